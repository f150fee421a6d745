// XML elements that know their position in the file, so that errors can name the line.
#pragma once

#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "waybreaker/error.hpp"

namespace waybreaker::authors {

// A parsed file. `bytes` and `name` must outlive it.
class XmlFile {
  public:
    // Throws InputError if the bytes are not well-formed XML.
    XmlFile(std::string_view bytes, const std::string& name);

    class Element;
    struct Attribute;
    Element root() const;

  private:
    InputError error(std::ptrdiff_t offset, const std::string& message) const;

    std::string_view bytes_;
    const std::string& name_;
    pugi::xml_document document_;
};

class XmlFile::Element {
  public:
    Element(const XmlFile& file, pugi::xml_node node) : file_(&file), node_(node) {}

    const char* tag() const { return node_.name(); }
    std::string_view text() const { return node_.child_value(); }
    // Without white space at its ends.
    std::string_view trimmed_text() const;

    // The child with that tag (lower case; the file may write it in any case). Throws InputError if there are several.
    std::optional<Element> find(std::string_view tag) const;
    // The same; throws if there is none.
    Element get(std::string_view tag) const;
    // Whether that is its tag (lower case).
    bool is(std::string_view tag) const;
    std::optional<Attribute> attribute(const char* name) const;
    // All elements within, whatever their tags.
    template <class Visit>
    void for_each_child(Visit visit) const {
        for (const pugi::xml_node child : node_.children()) {
            if (child.type() == pugi::node_element) visit(Element(*file_, child));
        }
    }

    // That names the line of the element.
    InputError error(const std::string& message) const { return file_->error(node_.offset_debug(), message); }

  private:
    const XmlFile* file_;
    pugi::xml_node node_;
};

struct XmlFile::Attribute {
    Element of;
    const char* name;
    std::string_view value;

    const char* tag() const { return name; }
    std::string_view trimmed_text() const { return value; }
    // That names the line of the element.
    InputError error(const std::string& message) const { return of.error(message); }
};

// Whether bytes begin as XML does.
bool is_xml(std::string_view bytes);

}  // namespace waybreaker::authors

// The authors' XML task files, written: what authors_xml.hpp reads.
#pragma once

#include <pugixml.hpp>
#include <string>

#include "authors/authors_xml.hpp"

namespace waybreaker::authors {

// Adds the elements <map> and <algorithm>. What the format has no word for (a planner, say) is left out.
void append_task(pugi::xml_node root, const io::MapFile& file, const io::MapTask& task);

// The text of a document, indented.
std::string text_of(const pugi::xml_document& document);

// A whole task file: the map and its task.
std::string authors_xml_text(const io::MapFile& file);

}  // namespace waybreaker::authors

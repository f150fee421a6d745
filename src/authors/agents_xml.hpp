// The agents of tasks for many, as programs of the authors' group read them. Each task of AA-SIPP(m) has them in one of
//
//     <root> <agents> <defaultparameters size="0.4" movespeed="0.25"/>
//                     <agent id="a" start.x="7" start.y="35" goal.x="0" goal.y="12" size="0.5"/> </agents> </root>
//     <root> <map> ... <agents>2</agents> <startx>2</startx> <starty>3</starty> <finishx>5</finishx> ... </map> </root>
//
// and those of CCBS, which count rows (i) and columns (j):
//
//     <root> <agent start_i="4" start_j="8" goal_i="8" goal_j="1"/> </root>
//
// `size` is the radius. Agents are called by their ids, or as in those programs by numbers from 0. They turn at once
// here: headings and speeds of rotation are not heeded.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "authors/xml_element.hpp"
#include "waybreaker/mission.hpp"

namespace waybreaker::authors {

struct XmlAgents {
    std::vector<Agent> agents;
    bool turn = false;  // the file says where they look, or how fast they turn
};

// None where the root holds no agents. Throws InputError with name and line.
XmlAgents agents_of(const XmlFile::Element& root);

// Of a file, with a map or without. Throws InputError with name and line, also if it has none.
XmlAgents parse_agents_xml(std::string_view bytes, const std::string& name);

// That a file has no map, and what it seems to be.
InputError no_map(const XmlFile::Element& root);

}  // namespace waybreaker::authors

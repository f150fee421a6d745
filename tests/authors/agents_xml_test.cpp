// Tasks for many agents: AA-SIPP(m) and CCBS.
#include "authors/agents_xml.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "authors/authors_xml.hpp"
#include "input_error.hpp"

namespace waybreaker::authors {
namespace {

XmlAgents agents_in(const std::string& text) {
    return parse_agents_xml(text, "a.xml");
}

std::string refusal(const std::string& text) {
    return input_error([&] { agents_in(text); });
}

constexpr const char* small_map =
    "<map type=\"grid\"><grid width=\"3\" height=\"2\"><row>0 0 1 </row><row>0 1 0 </row></grid></map>";

TEST(AgentsXml, AreThoseOfAaSipp) {
    const XmlAgents listed = agents_in(
        "<root>\n<agents number=\"3\">\n<agent id=\"bus\" start.x=\"7\" start.y=\"35\" goal.x=\"0\" goal.y=\"12\"/>"
        "<agent start.x=\"0\" start.y=\"30\" goal.x=\"28\" goal.y=\"20\" size=\"0.5\" movespeed=\"3\"/>\n"
        "<defaultparameters size=\"0.4\" movespeed=\"0.25\"/></agents></root>");
    EXPECT_FALSE(listed.turn);
    const std::vector<Agent>& agents = listed.agents;
    ASSERT_EQ(agents.size(), 2U);
    EXPECT_EQ(agents[0].id, "bus");
    EXPECT_EQ(agents[0].kind, AgentKind::ground);
    EXPECT_EQ(agents[0].start, (Cell{7, 35}));
    EXPECT_EQ(agents[0].goal, (Cell{0, 12}));
    EXPECT_EQ(agents[0].body.radius, 0.4);
    EXPECT_EQ(agents[0].speed, 0.25);
    EXPECT_EQ(agents[1].id, "1");
    EXPECT_EQ(agents[1].start, (Cell{0, 30}));
    EXPECT_EQ(agents[1].goal, (Cell{28, 20}));
    EXPECT_EQ(agents[1].body.radius, 0.5);
    EXPECT_EQ(agents[1].speed, 3);
}

TEST(AgentsXml, SayWhetherTheyTurn) {
    const auto turn = [](const std::string& of_all, const std::string& of_one) {
        return agents_in("<root><agents><defaultparameters " + of_all +
                         "/><agent start.x=\"0\" start.y=\"0\" goal.x=\"1\" goal.y=\"1\" " + of_one +
                         "/></agents></root>")
            .turn;
    };
    EXPECT_FALSE(turn("size=\"1\"", ""));
    EXPECT_TRUE(turn("rotationspeed=\"0.2\"", ""));
    EXPECT_TRUE(turn("", "goal.heading=\"90\""));
}

// i counts rows, j columns.
TEST(AgentsXml, AreThoseOfCcbs) {
    const XmlAgents ccbs = agents_in(
        "<root><agent start_i=\"4\" start_j=\"8\" goal_i=\"8\" goal_j=\"1\"/>"
        "<agent id=\"7\" start_i=\"5\" start_j=\"9\" goal_i=\"3\" goal_j=\"6\"/></root>");
    ASSERT_EQ(ccbs.agents.size(), 2U);
    EXPECT_EQ(ccbs.agents[0].id, "0");
    EXPECT_EQ(ccbs.agents[0].start, (Cell{8, 4}));
    EXPECT_EQ(ccbs.agents[0].goal, (Cell{1, 8}));
    EXPECT_EQ(ccbs.agents[1].id, "7");
    EXPECT_EQ(ccbs.agents[1].body.radius, 0.5);
}

std::string of_2018(const std::string& places) {
    return "<root><map>\n<width>3</width><height>2</height>\n" + places +
           "<grid><row>0 0 1</row><row>0 1 0</row></grid></map></root>";
}

TEST(AgentsXml, StandOneAfterTheOtherInTasksOf2018) {
    const std::string two =
        "<agents>2</agents><startx>0</startx><starty>1</starty><finishx>2</finishx><finishy>1</finishy>"
        "<startx>1</startx><starty>0</starty><finishx>0</finishx><finishy>0</finishy>";
    for (const std::vector<Agent>& agents :
         {agents_in(of_2018(two)).agents, parse_authors_xml(of_2018(two), "a.xml").task.agents}) {
        ASSERT_EQ(agents.size(), 2U);
        EXPECT_EQ(agents[0].id, "0");
        EXPECT_EQ(agents[0].goal, (Cell{2, 1}));
        EXPECT_EQ(agents[1].start, (Cell{1, 0}));
    }
    EXPECT_EQ(refusal(of_2018("<agents>1</agents>\n<startx>0</startx><finishx>2</finishx>")),
              "a.xml:4: <starty> of agent 0 must stand before <finishx>");
    EXPECT_EQ(refusal(of_2018("<agents>2</agents><startx>0</startx><starty>1</starty>")),
              "a.xml:3: <agents> is 2, which takes 8 coordinates, but there are 2");
    EXPECT_EQ(refusal(of_2018("<agents>many</agents>")),
              "a.xml:3: agents is 'many', but must be a number from 1 to 10000");
}

TEST(AgentsXml, StandBesideTheirMap) {
    const std::string agent = "<agent start.x=\"0\" start.y=\"1\" goal.x=\"1\" goal.y=\"0\"/>";
    const AuthorsXml task =
        parse_authors_xml("<root><agents>" + agent + "</agents>" + std::string(small_map) + "</root>", "a.xml");
    EXPECT_EQ(task.grid.width(), 3);
    EXPECT_TRUE(task.grid.blocked({2, 0}));
    EXPECT_FALSE(task.grid.blocked({2, 1}));
    ASSERT_EQ(task.task.agents.size(), 1U);
    EXPECT_EQ(task.task.agents[0].goal, (Cell{1, 0}));
    EXPECT_FALSE(task.task.start || task.task.goal);
    EXPECT_TRUE(parse_authors_xml("<root>" + std::string(small_map) + "</root>", "a.xml").task.agents.empty());
}

TEST(AgentsXml, AreRefusedWithLineAndReason) {
    const auto agents = [](const std::string& in) { return "<root>\n<agents>\n" + in + "</agents></root>"; };
    EXPECT_EQ(refusal("<root>"), "a.xml:1: not well-formed XML: Start-end tags mismatch");
    EXPECT_EQ(refusal("<root/>"),
              "a.xml: holds no agents: <agent> elements are expected, as tasks of AA-SIPP(m) and CCBS have them");
    EXPECT_EQ(refusal(agents("<agent start.x=\"1\" start.y=\"2\" goal.x=\"3\"/>")),
              "a.xml:3: goal.y is missing in 'agent'");
    EXPECT_EQ(refusal(agents("<agent start.x=\"1.5\" start.y=\"2\" goal.x=\"3\" goal.y=\"3\"/>")),
              "a.xml:3: start.x is '1.5', but must be a number from 0 to 32767");
    EXPECT_EQ(refusal(agents("<agent start.x=\"1\" start.y=\"2\" goal.x=\"-3\" goal.y=\"3\"/>")),
              "a.xml:3: goal.x is '-3', but must be a number from 0 to 32767");
    EXPECT_EQ(refusal(agents("<agent size=\"0\" start.x=\"1\" start.y=\"2\" goal.x=\"3\" goal.y=\"3\"/>")),
              "a.xml:3: size is '0', but must be a number from 0.001 to 32");
    EXPECT_EQ(refusal(agents("<agent movespeed=\"nan\" start.x=\"1\" start.y=\"2\" goal.x=\"3\" goal.y=\"3\"/>")),
              "a.xml:3: movespeed is 'nan', but must be a number from 1e-06 to 1e+06");
    EXPECT_EQ(refusal(agents("<agent id=\"\" start.x=\"1\" start.y=\"2\" goal.x=\"3\" goal.y=\"3\"/>")),
              "a.xml:3: the id of an agent must not be empty");
    EXPECT_EQ(refusal("<root><agent start_id=\"136\" goal_id=\"50\"/></root>"),
              "a.xml:1: this agent starts at a node of a roadmap, and maps are grids here: give a task for a grid");
    std::string crowd;
    for (int i = 0; i <= 10000; ++i) crowd += "<agent start.x=\"0\" start.y=\"0\" goal.x=\"1\" goal.y=\"1\"/>";
    EXPECT_EQ(refusal(agents(crowd)), "a.xml:3: a mission has at most 10000 agents");
}

TEST(AgentsXml, AreNoMapAndAreToldFromOne) {
    const auto no_map = [](const std::string& text) { return input_error([&] { parse_authors_xml(text, "a.xml"); }); };
    const std::string start = "a.xml:1: <map> is missing in 'root'";
    EXPECT_EQ(no_map("<root/>"), start);
    EXPECT_EQ(no_map("<root><agents/></root>"), start + "; it holds agents: give its map, and this file as the agents");
    EXPECT_EQ(no_map("<root><agent/></root>"), start + "; it holds agents: give its map, and this file as the agents");
    EXPECT_EQ(no_map("<root><dynamicobstacles/></root>"),
              start + "; it holds moving obstacles, which are not planned around");
    EXPECT_EQ(no_map("<root><algorithm/></root>"), start + "; it holds options of another program: give its map");
    EXPECT_EQ(no_map("<graphml><graph/></graphml>"),
              "a.xml:1: <map> is missing in 'graphml'; this is a roadmap (GraphML), and maps are grids here");
    EXPECT_EQ(no_map("<root><map><grid width=\"3\"><row>0 0 0</row></grid></map></root>"),
              "a.xml:1: <height> is missing in 'map'");
    EXPECT_EQ(no_map("<root><map><grid width=\"3\" height=\"none\"><row>0 0 0</row></grid></map></root>"),
              "a.xml:1: height is 'none', but must be a number from 1 to 32768");
}

}  // namespace
}  // namespace waybreaker::authors

// Map data for tests: a yard of 40 m around 9 degrees east, 50 degrees north.
#pragma once

#include <string>

namespace waybreaker::service {

// A house, a church and a lane.
inline std::string osm_yard() {
    return "<osm version='0.6'>\n"
           "<bounds minlat='49.9998' minlon='8.9997' maxlat='50.0002' maxlon='9.0003'/>\n"
           "<node id='1' lat='49.9999' lon='8.9998'/><node id='2' lat='49.9999' lon='8.9999'/>"
           "<node id='3' lat='50.0001' lon='8.9999'/><node id='4' lat='50.0001' lon='8.9998'/>\n"
           "<node id='5' lat='49.9999' lon='9.0001'/><node id='6' lat='49.9999' lon='9.0002'/>"
           "<node id='7' lat='50.0001' lon='9.0002'/><node id='8' lat='50.0001' lon='9.0001'/>\n"
           "<node id='9' lat='49.9998' lon='9'/><node id='10' lat='50.0002' lon='9'/>\n"
           "<way id='11'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/>"
           "<tag k='building' v='yes'/></way>\n"
           "<way id='12'><nd ref='5'/><nd ref='6'/><nd ref='7'/><nd ref='8'/><nd ref='5'/>"
           "<tag k='building' v='church'/><tag k='name' v='Dom'/></way>\n"
           "<way id='13'><nd ref='9'/><nd ref='10'/><tag k='highway' v='residential'/></way>\n"
           "</osm>\n";
}

}  // namespace waybreaker::service

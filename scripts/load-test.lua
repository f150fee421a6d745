-- What each client of scripts/load-test asks (wrk): one mission after the other; at the end, which statuses came.
local missions = {}
for line in io.lines(os.getenv("LOAD_MISSIONS")) do missions[#missions + 1] = line end

local threads = {}
function setup(thread)
    threads[#threads + 1] = thread
    thread:set("first", #threads * 37)
end

function init()
    at = first
    statuses = {}
    headers = {["Content-Type"] = "application/json"}
end

function request()
    at = at % #missions + 1
    return wrk.format("POST", nil, headers, missions[at])
end

function response(status)
    statuses[status] = (statuses[status] or 0) + 1
end

function done(summary, latency)
    local sum = {}
    for _, thread in ipairs(threads) do
        for status, count in pairs(thread:get("statuses")) do sum[status] = (sum[status] or 0) + count end
    end
    for status, count in pairs(sum) do print(string.format("status %d: %d", status, count)) end
    print(string.format("p50 %.1f ms, p99 %.1f ms", latency:percentile(50) / 1000, latency:percentile(99) / 1000))
end

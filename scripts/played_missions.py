"""Clients that play live missions on servers, and what they hold the servers to: for prove-store and prove-shared-store."""
import hashlib
import http.client
import json
import random
import subprocess
import threading

MISSIONS = "/api/v1/missions"


class Wrong(Exception):
    """Something was lost, or done twice."""


def require(holds, what):
    if not holds:
        raise Wrong(what)


class Server:
    def __init__(self, program, store, *options):
        self.process = subprocess.Popen([program, "serve", "--port", "0", "--store", store, *options],
                                        stderr=subprocess.PIPE, stdout=subprocess.DEVNULL)
        first = self.process.stderr.readline()
        require(b'"listening"' in first, f"the server does not start: {first.decode()}")
        self.port = int(json.loads(first)["detail"].rsplit(":", 1)[1])
        threading.Thread(target=self.process.stderr.read, daemon=True).start()

    def kill(self):
        self.process.kill()
        self.process.wait()


class Connection:
    """Asks; gives None where the server has died."""

    def __init__(self, server):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=60)

    def ask(self, method, path, body=None, kind="application/json"):
        try:
            self.connection.request(method, path, body, {"Content-Type": kind} if body else {})
            answer = self.connection.getresponse()
            return answer.status, answer.read()
        except (OSError, http.client.HTTPException):
            return None


def thicket(seed):
    """A map with many small obstacles, free at its corners."""
    draw = random.Random(seed)
    side = 60
    rows = [[draw.random() < 0.12 for _ in range(side)] for _ in range(side)]
    for y in range(side):
        for x in range(side):
            if (x < 4 and y < 4) or (x >= side - 4 and y >= side - 4):
                rows[y][x] = False
    text = "".join("".join("@" if blocked else "." for blocked in row) + "\n" for row in rows)
    return f"type octile\nheight {side}\nwidth {side}\nmap\n{text}".encode()


def agent(name, kind, start, goal):
    return {"id": name, "kind": kind, "start": start, "goal": goal}


class Mission:
    """What a client knows of a mission: all that was acknowledged."""

    def __init__(self, answer):
        self.id = answer["id"]
        self.path = f"{MISSIONS}/{self.id}"
        self.plan = answer["plan"]
        self.now = 0
        self.sequence = 0
        self.acknowledged = {}  # by sequence: the report, and the bytes of its answer
        self.pending = None  # a report without an answer
        self.leaving = False  # it is asked to be deleted

    def take(self, body, answer):
        report = json.loads(answer)
        self.acknowledged[report["sequence"]] = (body, answer)
        self.now = report["now"]
        if report["plan"]:
            self.plan = report["plan"]


class Client:
    def __init__(self, number, seed):
        self.draw = random.Random(f"{seed} {number}")
        self.missions = []
        self.beginning = False  # a mission without an answer
        self.ended = []  # ids
        self.counts = {"begun": 0, "reports": 0, "refused": 0, "deleted": 0}

    def play(self, server):
        """Until the server dies."""
        connection = Connection(server)
        while True:
            chance = self.draw.random()
            if len(self.missions) < 3 or (chance < 0.05 and len(self.missions) < 8):
                alive = self.begin(connection)
            elif chance < 0.08:
                alive = self.end(connection, self.draw.choice(self.missions))
            else:
                alive = self.report(connection, self.draw.choice(self.missions))
            if not alive:
                return

    def request(self, connection):
        """One of a few missions, on a map of the server or on one that is sent; None where the server has died."""
        chance = self.draw.random()
        if chance < 0.3:
            return {"map": "berlin-mitte.tif", "mission": {"start": [485, 101], "goal": [425, 488]},
                    "options": {"removals": 1}}
        sent = connection.ask("POST", "/api/v1/maps", thicket(self.draw.randrange(4)), "application/octet-stream")
        if sent is None:
            return None
        agents = [agent("rover", "ground", [1, 1], [58, 58])]
        if chance < 0.6:
            agents.append(agent("heli", "air", [1, 1], [58, 58]))
        return {"format": "waybreaker-mission/1", "map": json.loads(sent[1])["id"], "agents": agents}

    def begin(self, connection):
        request = self.request(connection)
        if request is None:
            return False
        self.beginning = True
        answer = connection.ask("POST", MISSIONS, json.dumps(request))
        if answer is None:
            return False
        self.beginning = False
        require(answer[0] == 201, f"no mission: {answer}")
        self.missions.append(Mission(json.loads(answer[1])))
        self.counts["begun"] += 1
        return True

    def end(self, connection, mission):
        mission.leaving = True
        answer = connection.ask("DELETE", mission.path)
        if answer is None:
            return False
        require(answer[0] == 204, f"not deleted: {answer}")
        self.missions.remove(mission)
        self.ended.append(mission.id)
        self.counts["deleted"] += 1
        return True

    def news(self, mission):
        """A vehicle that is late, a breach that has failed, something in the way; or nothing new."""
        now = mission.now + self.draw.uniform(0.01, 4)
        mission.sequence += self.draw.choice([1, 1, 1, 2, 7])
        state = {"format": "waybreaker-state/1", "sequence": mission.sequence, "now": now}
        chance = self.draw.random()
        if chance < 0.3:
            path = next(one["path"] for one in mission.plan["agents"] if one["kind"] == "ground")
            then = now - self.draw.uniform(0, 2)
            passed = max([i for i, point in enumerate(path) if point[2] <= then], default=0)
            name = next(one["id"] for one in mission.plan["agents"] if one["kind"] == "ground")
            state["agents"] = [{"id": name, "passed": passed, "at": path[passed][:2]}]
        elif chance < 0.5:
            failed = [one for one in mission.plan["removed"] if one["cleared_at"] <= now]
            state["failed"] = [{"obstacle": one["obstacle"], "at": one["cleared_at"]} for one in failed[:1]]
        elif chance < 0.6:
            cell = [self.draw.randrange(60), self.draw.randrange(60)]
            state["found"] = [{"cells": [cell], "blocked": self.draw.random() < 0.5}]
        return json.dumps(state)

    def report(self, connection, mission):
        mission.pending = self.news(mission)
        return self.settle(connection, mission)

    def settle(self, connection, mission):
        """Asks until the report is acknowledged, or refused; whether the server lives."""
        answer = connection.ask("POST", mission.path + "/reports", mission.pending)
        if answer is None:
            return False
        require(answer[0] in (200, 422), f"no answer to {mission.pending}: {answer}")
        if answer[0] == 200:
            mission.take(mission.pending, answer[1])
            self.counts["reports"] += 1
        else:
            self.counts["refused"] += 1
        mission.pending = None
        return True

    def recover(self, connection, listed, all_reports):
        """After a restart: everything acknowledged is there, what was on its way is done or done again."""
        for name in self.ended:
            require(name not in listed, f"{name} was deleted, and is back")
        for mission in list(self.missions):
            if mission.leaving and mission.id not in listed:
                self.missions.remove(mission)
                self.ended.append(mission.id)
                continue
            mission.leaving = False
            require(mission.id in listed, f"{mission.id} is lost")
            for sequence in sorted(mission.acknowledged)[0 if all_reports else -20:]:
                body, before = mission.acknowledged[sequence]
                answer = connection.ask("POST", mission.path + "/reports", body)
                require(answer == (200, before), f"report {sequence} of {mission.id} gives another answer")
            if mission.pending:
                require(self.settle(connection, mission), "the server died by itself")
            require_chain(connection, mission)


def events_of(connection, mission, last):
    """The data of all events, up to that sequence number."""
    connection.connection.request("GET", mission.path + "/events", headers={"Last-Event-ID": "0"})
    answer = connection.connection.getresponse()
    events = []
    while last > 0 and (not events or events[-1]["sequence"] < last):
        line = answer.readline().decode()
        require(line, "the events end too early")
        if line.startswith("data: "):
            events.append(json.loads(line[6:]))
    connection.connection.close()
    return events


def require_chain(connection, mission):
    """Revisions are counted one by one, and each plan supersedes the one before."""
    summary = json.loads(connection.ask("GET", mission.path)[1])
    events = events_of(connection, mission, summary["sequence"])
    sequences = [event["sequence"] for event in events]
    require(sequences == sorted(set(sequences)), f"{mission.id}: a report was taken twice")
    require(set(mission.acknowledged) <= set(sequences), f"{mission.id}: a report has no event")
    revisions = [event["revision"] for event in events if event["status"] in ("kept", "revised")]
    require(revisions == list(range(1, summary["revision"] + 1)), f"{mission.id}: revisions {revisions}")
    digest = None
    for revision in range(summary["revision"] + 1):
        plan = connection.ask("GET", f"{mission.path}/plan?revision={revision}")[1]
        if digest:
            require(json.loads(plan)["revision"]["supersedes"] == digest, f"{mission.id}: revision {revision}")
        digest = "sha256:" + hashlib.sha256(plan).hexdigest()

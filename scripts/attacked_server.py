"""A server under attack: what it uses, what is said to it, and a client that only wants its plan. For scripts/attack."""
import json
import os
import re
import socket
import subprocess
import threading
import time

MIB = 1 << 20
HOST = "127.0.0.1"


class Server:
    """The program at work, and what it uses."""

    def __init__(self, program, *options):
        self.process = subprocess.Popen([program, "serve", "--port", "0", *options], stderr=subprocess.PIPE,
                                        stdout=subprocess.DEVNULL)
        self.program = program
        self.port = int(json.loads(self.process.stderr.readline())["detail"].rsplit(":", 1)[1])
        self.peak = 0
        self.threads = 0
        self.watching = True
        threading.Thread(target=self.read_log, daemon=True).start()
        self.watcher = threading.Thread(target=self.watch, daemon=True)
        self.watcher.start()

    def read_log(self):
        for _ in self.process.stderr:
            pass

    def status(self, name):
        with open(f"/proc/{self.process.pid}/status") as file:
            return int(re.search(rf"^{name}:\s+(\d+)", file.read(), re.M).group(1))

    def memory(self):
        """Of the program, and of the processes that it has started."""
        children = []
        for task in os.listdir(f"/proc/{self.process.pid}/task"):
            try:
                with open(f"/proc/{self.process.pid}/task/{task}/children") as file:
                    children += file.read().split()
            except OSError:
                pass
        bytes_of = [self.status("VmRSS")]
        for child in set(children):
            try:
                with open(f"/proc/{child}/status") as file:
                    bytes_of.append(int(re.search(r"^VmRSS:\s+(\d+)", file.read(), re.M).group(1)))
            except (OSError, AttributeError):
                pass
        return sum(bytes_of) / 1024

    def counted(self):
        """What it counts itself, in MiB."""
        _, text = ask(self, "GET", "/metrics")
        return sum(int(n) for n in re.findall(rb"^waybreaker_memory_bytes\S* (\d+)$", text, re.M)) / MIB

    def processor(self):
        with open(f"/proc/{self.process.pid}/stat") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / 100

    def watch(self):
        while self.watching:
            try:
                self.peak = max(self.peak, self.memory())
                self.threads = max(self.threads, self.status("Threads"))
            except (OSError, AttributeError):
                return
            time.sleep(0.02)

    def connect(self, timeout=60):
        return socket.create_connection((HOST, self.port), timeout)

    def end(self):
        self.watching = False
        self.watcher.join()
        self.process.kill()
        self.process.wait()


def everything(wire):
    """All that is said until the connection ends."""
    said = b""
    try:
        while piece := wire.recv(65536):
            said += piece
    except OSError:
        pass
    return said


def say(server, text, timeout=5):
    with server.connect(timeout) as wire:
        try:
            wire.sendall(text)
            wire.shutdown(socket.SHUT_WR)
        except OSError:
            pass
        return everything(wire)


def ask(server, method, path, body=b"", kind="application/octet-stream", timeout=300):
    """The status and the body of an answer."""
    head = f"{method} {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n"
    if body:
        head += f"Content-Type: {kind}\r\nContent-Length: {len(body)}\r\n"
    with server.connect(timeout) as wire:
        try:
            wire.sendall(head.encode() + b"\r\n" + body)
        except OSError:
            pass
        said = everything(wire)
    if not said:
        return 0, b""
    return int(said.split(b" ", 2)[1]), said.partition(b"\r\n\r\n")[2]


def together(count, task):
    threads = [threading.Thread(target=task, args=(i,), daemon=True) for i in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


class GoodClient:
    """Asks whether the server is there, or for a plan, on a new connection each time; how long it waits, at worst."""

    def __init__(self, server, plans=False):
        self.server, self.waits, self.going, self.refused = server, [], True, 0
        self.request = ("GET", "/healthz")
        if plans:
            mission = {"mission": {"start": [485, 101], "goal": [425, 488]}, "options": {"removals": 1}}
            self.request = ("POST", "/api/v1/maps/berlin-mitte.tif/plan", json.dumps(mission).encode(), "application/json")
        self.thread = threading.Thread(target=self.ask, daemon=True)
        self.thread.start()

    def ask(self):
        while self.going or not self.waits:
            began = time.monotonic()
            try:
                status, _ = ask(self.server, *self.request, timeout=150)
            except OSError:
                status = 0
            self.refused += status == 503
            self.waits.append(time.monotonic() - began if status in (200, 503) else float("inf"))
            time.sleep(0.05)

    def end(self):
        self.going = False
        self.thread.join()
        asks = "for plans" if len(self.request) > 2 else "whether the server is there"
        refused = f", {self.refused} refused" if self.refused else ""
        return f"a good client asks {asks}: waits {max(self.waits):.3f} s at worst, in {len(self.waits)} requests{refused}"

"""What `tip lsp` takes, as an editor sees it: bench.py TIP. Needs nothing but Python."""

import json
import random
import subprocess
import sys
import time

URI = "file:///robot/long.prg"
TEN_LINES = (
    "L{0}: A = {0}\nPTP F1 -400 200 -200\nB = A\nFOR N = 1 TO 3\n  SLEEP B\nNEXT\nIF KB_HIT THEN\n"
    "  MESSAGE 歩数 %A%\nENDIF\nGOSUB LIFT:  // ｱ\n"
)


def program(lines: int) -> str:
    """A program of so many lines, with all that a page of motion has."""
    body = "".join(TEN_LINES.format(number) for number in range(lines // 10 - 1))
    used = "".join(f"IF KB_HIT GOTO L{number}:\n" for number in range(5))
    return f"3.1\n歩く\nDEF_VAR A, B, N\n{body}{used}EXIT\nLIFT:\nREM\nRETURN\nEND\n"


class Editor:
    def __init__(self, tip: str):
        self.process = subprocess.Popen([tip, "lsp"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.asked, self.version = 0, 0
        self.ask("initialize", {"processId": None, "rootUri": None, "capabilities": {}})
        self.tell("initialized", {})

    def send(self, message: dict) -> None:
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n%s" % (len(body), body))
        self.process.stdin.flush()

    def receive(self) -> dict:
        length = 0
        while line := self.process.stdout.readline().strip():
            length = int(line.split(b":")[1])
        return json.loads(self.process.stdout.read(length))

    def tell(self, method: str, params) -> None:
        self.send({"method": method, "params": params})

    def ask(self, method: str, params) -> dict:
        self.asked += 1
        self.send({"id": self.asked, "method": method, "params": params})
        while (answer := self.receive()).get("id") != self.asked:
            pass
        return answer

    def findings(self) -> None:
        while self.receive().get("method") != "textDocument/publishDiagnostics":
            pass

    def open(self, text: str) -> None:
        item = {"uri": URI, "languageId": "tip", "version": 0, "text": text}
        self.tell("textDocument/didOpen", {"textDocument": item})
        self.findings()

    def change(self) -> None:
        self.version += 1
        place = {"line": 5000 + self.version, "character": 0}
        change = {"range": {"start": place, "end": place}, "text": " "}
        document = {"uri": URI, "version": self.version}
        self.tell("textDocument/didChange", {"textDocument": document, "contentChanges": [change]})
        self.findings()

    def at(self, method: str) -> None:
        place = {"line": random.randrange(5, 9900), "character": random.randrange(12)}
        self.ask(method, {"textDocument": {"uri": URI}, "position": place})

    def memory(self) -> float:
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as status:
            return int(status.read().split("VmHWM:")[1].split()[0]) / 1024

    def end(self) -> None:
        self.ask("shutdown", None)
        self.tell("exit", None)
        self.process.wait()


def timed(work, times: int) -> list[float]:
    taken = []
    for _ in range(times):
        start = time.perf_counter()
        work()
        taken.append(1000 * (time.perf_counter() - start))
    return sorted(taken)


def show(what: str, taken: list[float], limit: float, unit: str = "ms") -> None:
    middle, late = taken[len(taken) // 2], taken[min(len(taken) - 1, len(taken) * 99 // 100)]
    print(f"| {what} | {middle:.1f} {unit} | {late:.1f} {unit} | {limit} {unit} |")


def main(tip: str) -> None:
    random.seed(1)
    short, long = program(1_000), program(10_000)

    def first() -> None:
        editor = Editor(tip)
        editor.open(short)
        editor.end()

    print("| what | median | p99 | limit |\n|---|---:|---:|---:|")
    show("process start to first findings, 1,000 lines, and end", timed(first, 20), 50)
    editor = Editor(tip)
    editor.open(long)
    show("change to findings, 10,000 lines", timed(editor.change, 200), 30)
    # An editor that asks all the time would wait for what is found out after a change.
    time.sleep(0.5)
    show("hover", timed(lambda: editor.at("textDocument/hover"), 500), 5)
    show("completion", timed(lambda: editor.at("textDocument/completion"), 500), 5)
    show("memory", [editor.memory()], 60, "MB")
    editor.end()


main(sys.argv[1])

"""What a device does with calls, without a broker."""
import json
import threading
import time
import unittest

import rats
from rats.device import Device

ROOT = "rats/1/home/"


class Broker:
    """Keeps what is published, and lets tests wait for it."""

    def __init__(self):
        self.said = []
        self.news = threading.Condition()

    def publish(self, topic, payload, qos, retain, properties=None):
        with self.news:
            self.said.append((topic, json.loads(payload) if payload else None, retain))
            self.news.notify_all()

    def results(self, identifier, caller=""):
        return [said for topic, said, _ in self.said
                if topic.startswith(ROOT + "result/" + caller) and said["id"] == identifier]

    def result(self, identifier, number=1, caller=""):
        with self.news:
            self.news.wait_for(lambda: len(self.results(identifier, caller)) >= number, 5)
        return self.results(identifier, caller)[number - 1]


class Message:
    def __init__(self, topic, payload, retain=False):
        self.topic, self.retain, self.properties = ROOT + topic, retain, None
        self.payload = payload if isinstance(payload, bytes) else json.dumps(payload).encode()


class DeviceTest(unittest.TestCase):
    def setUp(self):
        self.device = Device("oven-1", namespace="https://example.org/ovens#", type="Oven",
                             classes={"Oven": "maestro:Device"},
                             words=[rats.word("hot", "?o - Oven", observable=True)],
                             things=[rats.Thing("pizza", "Oven")])
        self.broker = Broker()
        self.device._client, self.device._root = self.broker, ROOT
        self.done = []
        self.go = threading.Event()

        @self.device.feature("bake", inputs={"dish": "Oven"}, occupies=["chamber"], effect="(hot ?self)",
                             cost=2, seconds=60)
        def bake(call, dish):
            self.done.append(dish)
            if dish == "stone":
                raise rats.Refused("A stone does not bake", refs=[
                    {"fact": "(hot oven-1)", "need": "true", "have": False}])
            if dish == "slow":
                while not self.go.is_set():
                    call.sleep(0.01)
            if dish == "bomb":
                raise ValueError("boom")
            return {"heat": 220}

    def call(self, identifier, feature="bake", member="oven-1", retain=False, **more):
        message = {"v": "1.0", "id": identifier, "r": member, "f": feature, "t": 5000, "from": "cca",
                   "p": {"dish": {"ref": "https://example.org/ovens#pizza"}}, **more}
        self.device._heard(None, None, Message("call/cca", message, retain))

    def error(self, identifier, number=1):
        result = self.broker.result(identifier, number)
        return result["outcome"], result.get("error", {}).get("code")

    def test_words_say_all_that_descriptions_can_say_of_them(self):
        self.assertEqual(
            {"id": "own:level", "type": ["maestro:Fluent", "maestro:Observable"],
             "arguments": ["?t - Tank"], "unit": "http://qudt.org/vocab/unit/LITRE", "least": 0,
             "validFor": "PT10S", "equivalentProperty": "https://example.org/tanks#content"},
            rats.word("level", "?t - Tank", number=True, observable=True, least=0,
                      unit="http://qudt.org/vocab/unit/LITRE", valid_for="PT10S",
                      same_as="https://example.org/tanks#content"))
        self.assertEqual(
            {"id": "own:touches", "arguments": ["?a - Tank", "?b - Tank"],
             "type": ["maestro:Predicate", "owl:FunctionalProperty", "owl:SymmetricProperty"],
             "derivedWhen": "(full ?a)"},
            rats.word("touches", "?a - Tank", "?b - Tank", functional=True, symmetric=True,
                      derived_when="(full ?a)"))
        self.assertEqual(
            {"id": "own:Vat", "type": "owl:Class", "subClassOf": "maestro:Thing",
             "equivalentClass": "https://example.org/tanks#Tank"},
            rats.kind("Vat", same_as="https://example.org/tanks#Tank"))

    def test_what_its_values_tell_whenever_it_is_so_is_described(self):
        oven = Device("oven-2", namespace="https://example.org/ovens#",
                      reports={"hot": "(hot ?self)"})
        self.assertEqual([{"name": "hot", "fact": "(hot ?self)"}], oven.description()["reports"])

    def test_a_call_is_done_and_answered(self):
        self.call("a")
        result = self.broker.result("a")
        self.assertEqual(("SUCCEEDED", {"heat": 220}), (result["outcome"], result["values"]))
        self.assertEqual(["pizza"], self.done)

    def test_what_is_continuous_goes_on_until_the_feature_that_ends_it(self):
        self.device.tell("(hot oven-1)")

        @self.device.feature("fan", inputs={"dish": "Oven"}, effect="(hot ?self)", continuous=True,
                             ended_by="halt")
        def fan(call, dish):
            call.established(speed=3)
            try:
                while True:
                    call.sleep(5)
            finally:
                self.done.append("fan ended")

        @self.device.feature("halt", inputs={"dish": "Oven"}, effect="(not (hot ?self))")
        def halt(call, dish):
            self.done.append("halt")

        offered = {offer.get("id"): offer for offer in self.device.description()["offers"]}
        self.assertEqual((True, "own:halt"), (offered["own:fan"]["continuous"],
                                              offered["own:fan"]["endedBy"]))
        self.call("a", feature="fan")
        with self.broker.news:
            self.broker.news.wait_for(lambda: any("/progress/" in topic for topic, _, _ in self.broker.said), 5)
        told = [said for topic, said, _ in self.broker.said if "/progress/" in topic]
        self.assertEqual(("ESTABLISHED", 1, {"speed": 3}),
                         (told[0]["kind"], told[0]["fraction"], told[0]["values"]))
        limit = self.device._reception.running["cca", "a"].timer
        self.assertTrue(limit.finished.is_set(), "its time goes on though it is established")
        self.call("b", feature="halt", p={"dish": "other"})
        self.assertEqual("SUCCEEDED", self.broker.result("b")["outcome"])
        self.assertEqual([], self.broker.results("a"), "another's end")
        self.call("c", feature="halt")
        self.assertEqual(("SUCCEEDED", None), self.error("a"))
        self.assertEqual(["fan ended", "halt", "halt"], sorted(self.done))

    def test_the_same_call_again_is_answered_and_not_done_again(self):
        self.call("a")
        first = self.broker.result("a")
        self.call("a")
        self.assertEqual(first, self.broker.result("a", 2))
        self.assertEqual(["pizza"], self.done)
        self.call("a", p={"dish": "other"})
        self.assertEqual(("REJECTED", "DUPLICATE_ID"), self.error("a", 3))

    def test_what_is_not_for_it_is_not_done(self):
        self.call("a", retain=True)
        self.call("b", member="oven-2")
        self.call("c", **{"from": "somebody"})
        self.call("d", feature="fly", member="")
        self.call("e", boot="another")
        self.assertEqual(("REJECTED", "RESTARTED"), self.error("e"))
        self.assertEqual(("REJECTED", "UNKNOWN_FEATURE"), (self.call("f", feature="fly"), self.error("f"))[1])
        self.assertEqual(("REJECTED", "INVALID_PARAMETERS"), (self.call("g", p={}), self.error("g"))[1])
        self.assertEqual(("REJECTED", "UNSUPPORTED_VERSION"), (self.call("h", v="2.0"), self.error("h"))[1])
        self.assertEqual(("REJECTED", "MALFORMED"), (self.call("i", t="soon"), self.error("i"))[1])
        self.assertEqual([], self.done)
        self.assertEqual([], [self.broker.results(one) for one in "abcd" if self.broker.results(one)])

    def test_rubbish_does_no_harm(self):
        for payload in (b"{{", b"[]", b"\xff\xfe", b"3", b'{"id": 3}', b"[" * 100000):
            self.device._heard(None, None, Message("call/cca", payload))
        self.call("a")
        self.assertEqual("SUCCEEDED", self.broker.result("a")["outcome"])

    def test_a_refusal_names_what_it_needs(self):
        self.call("a", p={"dish": "stone"})
        result = self.broker.result("a")
        self.assertEqual("REJECTED", result["outcome"])
        self.assertEqual("true", result["error"]["refs"][0]["need"])
        self.assertEqual(("FAILED", "INTERNAL"), (self.call("b", p={"dish": "bomb"}), self.error("b"))[1])

    def test_who_occupies_the_same_waits(self):
        self.call("a", p={"dish": "slow"})
        self.call("b")
        self.assertEqual([], self.broker.results("b"))
        states = [said for topic, said, _ in self.broker.said if topic.endswith("/state")]
        self.assertEqual((["a"], ["b"]), (states[-1]["running"], states[-1]["queue"]))
        self.go.set()
        self.assertEqual("SUCCEEDED", self.broker.result("b")["outcome"])
        self.assertEqual(["slow", "pizza"], self.done)

    def test_calls_are_canceled_where_they_are(self):
        self.call("a", p={"dish": "slow"})
        self.call("b")
        self.call("c", feature="$cancel", p={"id": "b"})
        self.assertEqual({"found": True}, self.broker.result("c")["values"])
        self.assertEqual(("CANCELED", "CANCELED"), self.error("b"))
        self.call("d", feature="$cancel", p={"id": "a"})
        self.assertEqual(("CANCELED", "CANCELED"), self.error("a"))
        self.call("e", feature="$cancel", p={"id": "nobody"})
        self.assertEqual({"found": False}, self.broker.result("e")["values"])
        self.assertEqual(["slow"], self.done)

    def test_time_runs_out_waiting_and_running(self):
        self.call("a", p={"dish": "slow"}, t=200)
        self.call("b", t=100)
        self.assertEqual(("TIMED_OUT", "TIMEOUT"), self.error("b"))
        self.assertEqual(("TIMED_OUT", "TIMEOUT"), self.error("a"))

    def test_who_was_held_up_is_late(self):
        now = time.monotonic() * 1000
        self.call("a", sent={"clock": "k", "ms": now})
        self.call("b", sent={"clock": "k", "ms": now - 6000})
        self.assertEqual(("REJECTED", "EXPIRED"), self.error("b"))

    def test_it_becomes_safe(self):
        calm = []
        self.device.on_safe(lambda: calm.append(True))
        self.call("a", p={"dish": "slow"})
        self.call("s", feature="$safe", p={})
        self.assertEqual("SUCCEEDED", self.broker.result("s")["outcome"])
        self.assertEqual(("CANCELED", "CANCELED"), self.error("a"))
        self.assertEqual([True], calm)

    def test_prices_are_told(self):
        self.call("a", feature="$cost", p={"feature": "bake", "sets": [{}, {}]})
        self.assertEqual([{"cost": 2.0, "seconds": 60.0}] * 2, self.broker.result("a")["values"]["costs"])

        @self.device.price("bake", at_least=1)
        def price(dish):
            if dish == "whale":
                raise rats.UnknownPrice("It does not fit")
            return rats.Price(4, 3)

        self.call("b", feature="$cost", p={"feature": "bake", "sets": [{"dish": "pie"}, {"dish": "whale"}]})
        self.assertEqual([{"cost": 4, "seconds": 3}, {"reason": "It does not fit"}],
                         self.broker.result("b")["values"]["costs"])

    def test_a_price_that_breaks_is_answered(self):
        @self.device.price("bake")
        def price(dish):
            raise KeyError("no scales")

        self.call("a", feature="$cost", p={"feature": "bake", "sets": [{}]})
        self.assertEqual(("FAILED", "INTERNAL"), self.error("a"))

    def test_callers_choose_the_same_id(self):
        self.call("a", p={"dish": "slow"})
        message = {"v": "1.0", "id": "a", "r": "oven-1", "f": "bake", "t": 5000, "from": "other", "p": {"dish": "pie"}}
        self.device._heard(None, None, Message("call/other", message))
        self.call("c", feature="$cancel", p={"id": "a"})
        self.assertEqual("CANCELED", self.broker.result("a", caller="cca")["outcome"])
        self.assertEqual("SUCCEEDED", self.broker.result("a", caller="other")["outcome"])
        self.assertEqual(["slow", "pie"], self.done)

    def test_what_cannot_be_told_has_failed(self):
        @self.device.feature("odd")
        def odd(call):
            return {"x": {1}} if call.id == "a" else 5 if call.id == "b" else {"x": float("nan")}

        for identifier in "abc":
            self.call(identifier, feature="odd", p={})
            self.assertEqual(("FAILED", "INTERNAL"), self.error(identifier))

    def test_nothing_begins_while_it_becomes_safe(self):
        reached, go = threading.Event(), threading.Event()

        @self.device.on_safe
        def calm():
            reached.set()
            go.wait(5)

        self.call("s", feature="$safe", p={})
        reached.wait(5)
        self.call("a")
        self.assertEqual(("REJECTED", "DISABLED"), self.error("a"))
        go.set()
        self.assertEqual("SUCCEEDED", self.broker.result("s")["outcome"])

    def test_an_unsafe_end_is_told(self):
        @self.device.on_safe
        def breaks():
            raise OSError("stuck")

        self.call("s", feature="$safe", p={})
        self.assertEqual(("FAILED", "INTERNAL"), self.error("s"))

    def test_what_is_so_is_told(self):
        self.device.tell("(hot oven-1)")
        self.device.tell_number("(heat oven-1)", 20)
        self.device.tell_number("(heat oven-1)", 1234567.5)
        self.assertEqual(["(hot oven-1)", "(= (heat oven-1) 1234567.5)"], self.device.values)
        self.device.untell("(hot oven-1)")
        self.assertEqual(["(= (heat oven-1) 1234567.5)"], self.broker.said[-1][1]["values"])

    def test_it_calls_others(self):
        answers = []
        asking = threading.Thread(target=lambda: answers.append(self.device.call("lamp-1", "shine", level=1)))
        asking.start()
        with self.broker.news:
            self.broker.news.wait_for(lambda: self.broker.said, 5)
        topic, call, _ = self.broker.said[-1]
        self.assertEqual((ROOT + "call/oven-1", "lamp-1", {"level": 1}), (topic, call["r"], call["p"]))
        self.device._heard(None, None, Message("result/oven-1/evil", {
            "id": call["id"], "outcome": "SUCCEEDED", "values": {"ok": 666}}))
        self.device._heard(None, None, Message("result/oven-1/lamp-1", {
            "id": call["id"], "outcome": "SUCCEEDED", "values": {"ok": 1}}))
        asking.join(5)
        self.assertEqual({"ok": 1}, answers[0].values)
        self.assertEqual("TIMED_OUT", self.device.call("lamp-1", "shine", timeout=0.05).outcome)

    def test_a_late_will_is_not_the_last_word(self):
        self.device._heard(None, None, Message("member/oven-1/status", {
            "id": "oven-1", "status": "lost", "boot": self.device.boot}))
        self.assertEqual("ready", self.broker.said[-1][1]["status"])

    def test_neither_is_that_of_another_life(self):
        self.device._heard(None, None, Message("member/oven-1/status", {
            "id": "oven-1", "status": "lost", "boot": "another"}))
        self.assertEqual("ready", self.broker.said[-1][1]["status"])

    def test_what_another_describes_is_not_the_last_word(self):
        self.device._heard(None, None, Message("member/oven-1/description", {"label": "a stone"}))
        self.assertEqual((ROOT + "member/oven-1/description", self.device.description(), True),
                         self.broker.said[-1])

    def test_a_call_with_half_a_character_is_refused(self):
        self.call("a", p={"dish": "\ud800"})
        self.assertEqual(("REJECTED", "MALFORMED"), self.error("a"))

    def test_a_call_needs_no_parameters(self):
        message = {"v": "1.0", "id": "a", "r": "oven-1", "f": "$ping", "t": 5000, "from": "cca"}
        self.device._heard(None, None, Message("call/cca", message))
        self.assertEqual("SUCCEEDED", self.broker.result("a")["outcome"])

    def test_a_refused_description_is_logged(self):
        fault = {"line": 0, "subject": "bake", "property": "effect", "problem": "is odd", "cure": "mend it"}
        with self.assertLogs("rats", "ERROR") as logged:
            self.device._heard(None, None, Message("controller/cca/verdict/oven-1", {
                "id": "oven-1", "accepted": False, "faults": [fault]}))
        self.assertIn("bake effect is odd; mend it", logged.output[0])

    def test_it_describes_itself(self):
        text = self.device.description()
        self.assertEqual("own:oven-1", text["id"])
        self.assertEqual({"id": "own:bake", "type": "maestro:Task", "effect": "(hot ?self)",
                          "seconds": "60", "cost": "2", "occupies": ["chamber"],
                          "input": [{"name": "dish", "types": ["own:Oven"]}]}, text["offers"][0])
        self.assertEqual(["own:Oven", "own:hot", "own:pizza"], [one["id"] for one in text["brings"]])


if __name__ == "__main__":
    unittest.main()

package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.SlParser;
import org.maestro.sl.TypedVariable;

/** Scripts are carried out step by step, beside goals and over the same robots. */
class ScriptsTest {
  private static Home home;

  private final Map<String, Script> scripts = new TreeMap<>();
  private NarrowHouse house;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  private void script(String name, String parameters, String body) {
    List<TypedVariable> variables =
        parameters.isEmpty()
            ? List.of()
            : List.of(parameters.split(", ")).stream().map(SlParser::variable).toList();
    scripts.put(
        name, new Script(name, variables, SlParser.body(body, home.vocabulary()::isFluent)));
  }

  private void script(
      String name, String parameters, String body, String benefit, Optional<Duration> allowed) {
    script(name, parameters, body);
    Script plain = scripts.get(name);
    scripts.put(
        name,
        new Script(
            name,
            name,
            plain.parameters(),
            plain.body(),
            Optional.of(SlParser.expression(benefit)),
            Optional.empty(),
            allowed));
  }

  private NarrowHouse house() {
    house =
        new NarrowHouse(home.withScripts(scripts), 1).with("rose", "zone-a").with("Cup", "zone-b");
    return house;
  }

  private GoalOutcome run(String goal) {
    String id = house().wish(goal);
    assertThat(house.run(1, Duration.ofMinutes(10))).as(house.told()).isTrue();
    assertThat(house.accidents).isEmpty();
    return house.outcomes.get(id);
  }

  @Test
  void stepsAreDoneInTheirOrder() {
    script(
        "tidy",
        "?item - Item, ?where - Zone",
        "(seq (do move rose :to zone-b) (do pick rose :object ?item) (do move rose :to ?where)"
            + " (do place rose :object ?item))");

    assertThat(run("(tidy Cup zone-c)").reached()).as(house.told()).isTrue();

    assertThat(house.calls).containsExactly("move rose", "pick rose", "move rose", "place rose");
    assertThat(house.outcomes.get("G1").calls()).isEqualTo(4);
    assertThat(house.place).containsEntry("Cup", "zone-c");
    assertThat(house.told())
        .contains(
            "G1 STEP [2] rose is to do pick :object Cup.", "G1 STEP [2] Step 1 of 1: rose picks");
  }

  /** It is what its member says that this call takes, and not what any would at least. */
  @Test
  void whatACallCostsIsAskedForWhereOnlyItsMemberKnows() {
    script("walk", "", "(do move rose :to zone-b)");

    assertThat(run("(walk)").reached()).isTrue();
    assertThat(house.told()).doesNotContain("Plan 1 (cost 0.5)").contains("[1] Plan 1 (cost 5)");
  }

  @Test
  void whatIsAchievedIsPlannedOverAllDevices() {
    script("fetch", "?item - Item", "(seq (achieve (in ?item zone-c)) (achieve (in rose zone-a)))");

    assertThat(run("(fetch Cup)").reached()).as(house.told()).isTrue();

    assertThat(house.place).containsEntry("Cup", "zone-c").containsEntry("rose", "zone-a");
    assertThat(house.told()).contains("[1] Plan 1 (cost ").contains("[2] Reached");
  }

  @Test
  void partsSideBySideContendAsGoalsDo() {
    script(
        "both",
        "",
        "(par (achieve (in Cup zone-a)) (achieve (in Mug zone-b)) (achieve (in tim zone-b)))");
    house().with("tim", "zone-c").with("Mug", "zone-a");
    String id = house.wish("(both)");
    house.run(1, Duration.ofMinutes(10));

    assertThat(house.outcomes.get(id).reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-a").containsEntry("Mug", "zone-b");
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void whatFailsIsRecoveredFromAndWhatIsLastIsDoneInAnyCase() {
    script(
        "careful",
        "",
        "(try (seq (do pick rose :object Cup) (fail \"never\"))"
            + " (recover \"no such reason\" (fail \"wrong\"))"
            + " (recover \"pick\" (do move rose :to zone-b))"
            + " (finally (do pick rose :object Cup)))");

    assertThat(run("(careful)").reached()).as(house.told()).isTrue();

    assertThat(house.calls).containsExactly("move rose", "pick rose");
    assertThat(house.told()).contains("Recovers from this: rose cannot pick now");
  }

  @Test
  void whatIsNotRecoveredFromFailsTheScriptWithItsReason() {
    script("hopeless", "", "(seq (do pick rose :object Cup) (do move rose :to zone-b))");

    GoalOutcome outcome = run("(hopeless)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.reasons()).singleElement().asString().contains("rose cannot pick now");
    assertThat(house.calls).isEmpty();
  }

  @Test
  void variablesStandForWhatIsFoundAndForWhatScriptsGive() {
    script("other", "?zone - Zone", "(if (= ?zone zone-a) (return zone-c) (return zone-a))");
    script(
        "away",
        "?item - Item",
        "(let ?here (one (?z - Zone) (in ?item ?z)) (let ?there (run other ?here)"
            + " (let ?load (value (mass ?item))"
            + " (if (< ?load 1) (achieve (in ?item ?there)) (fail \"too heavy\")))))");

    assertThat(run("(away Cup)").reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-a");
  }

  @Test
  void roundsGoOnAsLongAsTheConditionHolds() {
    script(
        "patrol",
        "",
        "(while (in Cup zone-b) (seq (do move rose :to zone-b) (do move rose :to zone-a)) :most 3)");

    GoalOutcome outcome = run("(patrol)");

    assertThat(outcome.reasons())
        .containsExactly("After 3 rounds it is still so that (in Cup zone-b).");
    assertThat(house.calls).hasSize(6);
  }

  @Test
  void eachIndividualHasItsTurn() {
    script(
        "gather", "?where - Zone", "(foreach (?i - Item) (in ?i zone-b) (achieve (in ?i ?where)))");
    house().with("Mug", "zone-b").with("Jar", "zone-c");
    String id = house.wish("(gather zone-a)");
    house.run(1, Duration.ofMinutes(10));

    assertThat(house.outcomes.get(id).reached()).as(house.told()).isTrue();
    assertThat(house.place)
        .containsEntry("Cup", "zone-a")
        .containsEntry("Mug", "zone-a")
        .containsEntry("Jar", "zone-c");
  }

  @Test
  void itWaitsForTimeAndForFactsAndStatesThem() {
    script("ready", "", "(seq (wait 90) (assert (in Mug zone-c)))");
    script("watch", "", "(seq (wait (in Mug zone-c)) (do move rose :to zone-b))");
    house();
    String watch = house.wish("(watch)");
    String ready = house.wish("(ready)");
    house.clock.run(Duration.ofSeconds(80));
    assertThat(house.state(watch)).isEqualTo(GoalState.RUNNING);
    assertThat(house.calls).isEmpty();

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();

    assertThat(house.outcomes.get(ready).duration())
        .isBetween(Duration.ofSeconds(90), Duration.ofSeconds(91));
    assertThat(house.outcomes.get(watch).reached()).isTrue();
    assertThat(house.calls).containsExactly("move rose");
  }

  /** A condition that goes on holding while nothing takes time keeps no processor busy. */
  @Test
  void roundsThatTakeNoTimeWaitForNews() {
    script("idle", "", "(while (in rose zone-a) (if (in Cup zone-c) (do move rose :to zone-b)))");
    house();
    String idle = house.wish("(idle)");
    house.clock.run(Duration.ofMinutes(10));
    assertThat(house.state(idle)).isEqualTo(GoalState.RUNNING);
    house.knowledge.state(new Source(Source.Kind.STATED, "us"), List.of("(in Cup zone-c)"));

    assertThat(house.run(1, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.get(idle).reached()).isTrue();
    assertThat(house.calls).containsExactly("move rose");
  }

  @Test
  void whenItIsCancelledWhatIsLastIsDone() {
    script(
        "outing",
        "",
        "(try (seq (do move rose :to zone-b) (do move rose :to zone-c) (wait 600))"
            + " (finally (achieve (in rose zone-a))))");
    house();
    String id = house.wish("(outing)");
    house.clock.run(Duration.ofSeconds(60));
    assertThat(house.place).containsEntry("rose", "zone-c");

    house.coordinator.cancel(id, "Bob");
    house.run(1, Duration.ofMinutes(5));

    assertThat(house.outcomes.get(id).state()).isEqualTo(GoalState.CANCELLED);
    assertThat(house.place).as(house.told()).containsEntry("rose", "zone-a");
  }

  @Test
  void twoScriptsRunAtTheSameTimeAndTheSecondOnOneRobotWaitsWithTheReason() {
    script("carry", "?item - Item, ?where - Zone", "(seq (achieve (in ?item ?where)))");
    script("walk", "?robot - Device, ?where - Zone", "(do move ?robot :to ?where)");
    house().with("tim", "zone-c");
    String first = house.wish("(carry Cup zone-a)");
    house.clock.run(Duration.ofMillis(500));
    String beside = house.wish("(walk tim zone-b)");
    String second = house.wish("(walk rose zone-b)");
    house.clock.run(Duration.ofMillis(500));

    assertThat(house.state(first)).isEqualTo(GoalState.RUNNING);
    assertThat(house.state(beside)).isEqualTo(GoalState.RUNNING);
    assertThat(house.state(second)).as(house.told()).isEqualTo(GoalState.WAITING);
    assertThat(house.status(second).detail()).contains("the base of rose is held by " + first);
    assertThat(house.run(3, Duration.ofMinutes(10))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).as(house.told()).allMatch(GoalOutcome::reached);
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void scriptsAndGoalsContendAsEquals() {
    script("tour", "", "(seq (achieve (in rose zone-b)) (achieve (in rose zone-c)))");
    house();
    String tour = house.wish("(tour)");
    house.clock.run(Duration.ofSeconds(1));
    String high = house.wish("(in Cup zone-a)", 5, Optional.empty());

    assertThat(house.run(2, Duration.ofMinutes(10))).as(house.told()).isTrue();

    assertThat(house.outcomes.keySet()).as(house.told()).containsExactly(high, tour);
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void scriptsRunEachOtherOnlySoDeep() {
    script("again", "", "(if (in Cup zone-b) (run again))");

    assertThat(run("(again)").reasons()).singleElement().asString().contains("more than 32 deep");
  }

  @Test
  void wrongValuesAreRefused() {
    script("fetch", "?item - Item", "(achieve (in ?item zone-c))");
    house();

    assertThatThrownBy(() -> house.wish("(fetch)"))
        .isInstanceOf(InvalidGoalException.class)
        .hasMessage("The script fetch takes 1 values, not 0; write (fetch ?item - Item).");
    assertThatThrownBy(() -> house.wish("(fetch zone-a)"))
        .hasMessageContaining("zone-a is no Item of this home");
    assertThatThrownBy(() -> house.wish("(fetch Kup)"))
        .hasMessageContaining("Kup is no Item of this home");
    assertThatThrownBy(() -> house.wish("(fetsch Cup)"))
        .hasMessage(
            "The goal names neither a predicate nor a script by fetsch;"
                + " write (fetch ?item - Item), if that is meant.");
    assertThatThrownBy(() -> house.wish("(polka Cup)"))
        .hasMessage(
            "The goal names neither a predicate nor a script by polka;"
                + " there are the scripts fetch, and ./maestro words lists the predicates.");
  }

  /**
   * Patrolling is worth 47.5 at any time; fetching, 15 to 20 at first, and ten times as much at the
   * end of its ten minutes.
   */
  @Test
  void ofTwoScriptsOnOneMotorTheHigherOneGoesFirstAndTheRankingFlipsAsTimePasses() {
    script(
        "patrol",
        "",
        "(while (in Mug zone-c) (try (seq (do move rose :to zone-b) (do move rose :to zone-a))"
            + " (recover \"cannot move\" (achieve (in rose zone-a)))))",
        "60",
        Optional.empty());
    script(
        "fetch",
        "?item - Item",
        "(achieve (in ?item zone-c))",
        "40",
        Optional.of(Duration.ofMinutes(10)));
    house().with("Mug", "zone-c");
    String patrol = house.wish("(patrol)");
    house.clock.run(Duration.ofSeconds(5));
    String fetch = house.wish("(fetch Cup)");
    house.clock.run(Duration.ofSeconds(80));

    assertThat(house.calls).as(house.told()).hasSizeGreaterThan(8).containsOnly("move rose");
    assertThat(house.told())
        .containsPattern(fetch + " WAIT \\[1] Stands back: " + patrol + "\\.1\\.\\S+ goes first");

    house.clock.runUntil(() -> house.outcomes.containsKey(fetch), Duration.ofMinutes(10));

    assertThat(house.outcomes.get(fetch).reached()).as(house.told()).isTrue();
    // 20·g is more than 47.5 from 92 s on, and 15·g five percent more from 156 s on.
    assertThat(house.outcomes.get(fetch).duration())
        .isBetween(Duration.ofSeconds(92), Duration.ofSeconds(200));
    assertThat(house.told())
        .containsPattern(patrol + " WAIT \\[\\S+] (Stands back: |Waits: .* by )" + fetch);
    int before = house.calls.size();
    house.clock.run(Duration.ofSeconds(30));

    assertThat(house.state(patrol)).as(house.told()).isEqualTo(GoalState.RUNNING);
    assertThat(house.calls).as("it goes on afterwards").hasSizeGreaterThan(before + 2);
    assertThat(house.accidents).isEmpty();
  }

  /** What a call leaves open is chosen when it has its turn. */
  @Test
  void aCallThatHasWaitedIsChosenAnewWhereThingsHaveChanged() {
    script("comeBack", "", "(do move rose :to zone-b)");
    house();
    house.wish("(in rose zone-c)");
    house.clock.run(Duration.ofSeconds(1));
    String back = house.wish("(comeBack)");
    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();

    assertThat(house.outcomes.get(back).reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("rose", "zone-b");
    assertThat(house.calls).containsExactly("move rose", "move rose", "move rose");
    assertThat(house.told())
        .contains(back + " REPLAN [1] Plan again, because things have changed while it waited.");
    assertThat(house.accidents).isEmpty();
  }

  /** What its script is worth is what a goal counts that asks for it. */
  @Test
  void itIsWeighedByWhatItsScriptIsWorth() {
    script("fetch", "?item - Item", "(achieve (in ?item zone-c))");
    Script plain = scripts.get("fetch");
    scripts.put(
        "fetch",
        new Script(
            "fetch",
            "fetch",
            plain.parameters(),
            plain.body(),
            Optional.of(SlParser.expression("(* 300 (mass ?item))")),
            Optional.of(0.9),
            Optional.of(Duration.ofMinutes(10))));
    house();
    String id = house.wish("(fetch Cup)");
    house.clock.run(Duration.ofSeconds(1));

    assertThat(house.status(id).worth().orElseThrow().benefit()).hasValue(60);
    assertThat(house.status(id).worth().orElseThrow().chance()).isEqualTo(0.9);
    assertThat(house.status(id).worth().orElseThrow().cost()).isEqualTo(17);
    List<String> told = new ArrayList<>(house.story);
    assertThat(told).isNotEmpty();
  }
}

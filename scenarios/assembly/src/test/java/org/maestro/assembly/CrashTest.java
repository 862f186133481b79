package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.fixtures.Share;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Script;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.Body;
import org.maestro.sl.SlParser;
import org.maestro.sl.TypedVariable;

/**
 * The coordinator dies at each entry of its journal, before and after it is whole, and another goes
 * on: every goal that was accepted comes to an end, and nothing is done twice.
 */
class CrashTest {
  private static final Set<String> DEEDS = Set.of("move", "pick", "place", "adjustLight");
  private static final List<String> GOALS =
      List.of("(nextTo Cup Bob)", "(canSee ?agent Cup)", "(>= (illuminance zone-a) 75)");
  private static final String SCRIPT = "(evening zone-a)";

  /** What is said and told in it; once more by who died before it was written down. */
  private static final List<String> LETTERS =
      List.of(
          "G1.4 The robot is in room A.",
          "G1.5 (ping (:room zone-a))",
          "G1.6 Shall it be dim?",
          "G1.6.1.1 calm");

  /** A goal whose plan has a script as a step, and a script that has such a goal. */
  private static final String PLAN = "(and (ready zone-b) (nextTo Cup Bob))";

  private static final String SCRIPT_WITH_PLAN = "(visit)";

  private static Home home;
  private static Scene scene;

  @TempDir Path directory;

  @BeforeAll
  static void load() throws IOException {
    home = new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl");
    scene =
        SceneLoader.load(
            "bob-dark",
            new ByteArrayInputStream(text("/scenes/bob-dark.ttl").getBytes(StandardCharsets.UTF_8)),
            home);
  }

  private static String text(String resource) throws IOException {
    try (InputStream stream = CrashTest.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void someEntries() throws IOException {
    int entries = entries();
    assertThat(entries).isGreaterThan(60);
    crash(entries / 4, 30);
    crash(entries * 3 / 4, 0);
  }

  @Test
  @Tag("full")
  void everyEntry() throws IOException {
    int entries = entries();
    for (long at : Share.of(LongStream.rangeClosed(1, entries)).toArray()) {
      crash((int) at, 0);
      crash((int) at, (int) (1 + at % 60));
    }
  }

  private int entries() throws IOException {
    try (MortalSite site = new MortalSite(home, scene, directory.resolve("whole"))) {
      site.begin(Integer.MAX_VALUE);
      run(site);
      assertThat(site.outcomes.values()).allMatch(outcome -> outcome.reached());
      return site.written();
    }
  }

  private static void run(MortalSite site) {
    site.clock.runUntil(() -> site.isDead() || site.allPresent(), Duration.ofMinutes(1));
    GOALS.forEach(site::submit);
    site.clock.runUntil(
        () -> site.isDead() || site.accepted.size() == GOALS.size() && site.allEnded(),
        Duration.ofMinutes(20));
  }

  /** Who dies before all goals are written down need not do what they ask for. */
  private void crash(int at, int torn) throws IOException {
    Path data = directory.resolve("at-" + at + "-" + torn);
    try (MortalSite site = new MortalSite(home, scene, data)) {
      site.begin(at);
      run(site);
      if (torn > 0) {
        site.tear(torn);
      }
      site.clock.run(Duration.ofMillis(100L * (at % 50)));
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(() -> site.allPresent() && site.allEnded(), Duration.ofMinutes(20));
      String context =
          "died at %d, torn by %d%n%s%n%s%n%s"
              .formatted(
                  at,
                  torn,
                  Files.readString(data.resolve("journal.jsonl")),
                  site.story.stream().map(String::valueOf).collect(Collectors.joining("\n")),
                  site.goals());
      assertThat(site.allEnded()).as(context).isTrue();
      assertThat(site.outcomes.values()).as(context).allMatch(outcome -> outcome.reached());
      assertThat(site.witness.executedTwice()).as(context).isEmpty();
      if (site.outcomes.size() == GOALS.size()) {
        assertThat(site.witness.doneTwice(DEEDS)).as(context).isEmpty();
      }
    }
  }

  @Test
  void someEntriesOfAScript() throws IOException {
    int entries = entriesOfScript();
    assertThat(entries).isGreaterThan(60);
    carryOut(entries / 4, 30);
    carryOut(entries * 3 / 4, 0);
  }

  @Test
  @Tag("full")
  void everyEntryOfAScript() throws IOException {
    int entries = entriesOfScript();
    for (long at : Share.of(LongStream.rangeClosed(1, entries)).toArray()) {
      carryOut((int) at, 0);
      carryOut((int) at, (int) (1 + at % 60));
    }
  }

  private static Home homeWithScript() {
    Body body =
        SlParser.body(
            """
            (seq (achieve (>= (illuminance zone-b) 72))
              (do move rose :to ?room)
              (look Cup)
              (say Bob "The robot is in" ?room ".")
              (tell CCA (ping (:room ?room)))
              (ask Bob "Shall it be dim?" ?dim boolean)
              (express calm 0.5)
              (if (= ?dim false) (fail "It is to stay bright."))
              (par (do adjustLight lamp-a1 :level 0.5) (do adjustLight lamp-a2 :level 0.25))
              (let ?dim (one (?l - Lamp) (= (level ?l) 0.5))
                (if (> (illuminance ?room) 1000)
                  (fail "much too bright")
                  (do adjustLight ?dim :level 0.75)))
              (try (fail "nothing to do")
                (recover (run homewards))
                (finally (foreach (?l - Lamp) (= (level ?l) 0.25) (do adjustLight ?l :level 0))))
              (while (in rose zone-b) (do move rose :to zone-a) :most 2)
              (hold rose "base" (do move rose :to zone-b) (do move rose :to zone-a)))
            """,
            home.vocabulary()::isFluent);
    Body homewards =
        SlParser.body("(seq (wait 5) (do move rose :to zone-b))", home.vocabulary()::isFluent);
    return home.withScripts(
        Map.of(
            "evening",
            script("evening", List.of(SlParser.variable("?room - Zone")), body),
            "homewards",
            script("homewards", List.of(), homewards)));
  }

  private static Script script(String name, List<TypedVariable> parameters, Body body) {
    return new Script(name, parameters, body);
  }

  private int entriesOfScript() throws IOException {
    try (MortalSite site = new MortalSite(homeWithScript(), scene, directory.resolve("script"))) {
      site.begin(Integer.MAX_VALUE);
      evening(site);
      assertThat(site.outcomes.values())
          .as(site.story.toString())
          .allMatch(outcome -> outcome.reached());
      return site.written();
    }
  }

  private static void evening(MortalSite site) {
    site.clock.runUntil(() -> site.isDead() || site.allPresent(), Duration.ofMinutes(1));
    site.submit(SCRIPT);
    site.clock.runUntil(
        () -> site.isDead() || site.accepted.size() == 1 && site.allEnded(),
        Duration.ofMinutes(20));
  }

  /** No finished step is done again, and the script ends. */
  private void carryOut(int at, int torn) throws IOException {
    Path data = directory.resolve("script-" + at + "-" + torn);
    try (MortalSite site = new MortalSite(homeWithScript(), scene, data)) {
      site.begin(at);
      evening(site);
      boolean accepted = !site.accepted.isEmpty();
      if (torn > 0) {
        site.tear(torn);
      }
      site.clock.run(Duration.ofMillis(100L * (at % 50)));
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(() -> site.allPresent() && site.allEnded(), Duration.ofMinutes(20));
      String context =
          "died at %d, torn by %d%n%s%n%s"
              .formatted(
                  at,
                  torn,
                  Files.readString(data.resolve("journal.jsonl")),
                  site.story.stream().map(String::valueOf).collect(Collectors.joining("\n")));
      assertThat(site.allEnded()).as(context).isTrue();
      assertThat(site.outcomes.values()).as(context).allMatch(outcome -> outcome.reached());
      assertThat(site.witness.executedTwice()).as(context).isEmpty();
      if (accepted) {
        assertThat(new LinkedHashSet<>(site.letters))
            .as(context)
            .containsExactlyElementsOf(LETTERS);
        assertThat(site.letters).as(context).hasSizeLessThanOrEqualTo(LETTERS.size() + 1);
        assertThat(site.answered).as(context).hasSizeLessThanOrEqualTo(1);
        assertThat(site.witness.doneTwice(Set.of("move", "adjustLight"))).as(context).isEmpty();
        assertThat(site.world().lampLevel("lamp-a1")).as(context).isEqualTo(0.75);
        assertThat(site.world().lampLevel("lamp-a2")).as(context).isZero();
      }
    }
  }

  @Test
  void someEntriesOfAScriptInAPlan() throws IOException {
    int entries = entriesOfScriptInPlan(PLAN);
    assertThat(entries).isGreaterThan(40);
    inPlan(PLAN, "G1.1", entries / 4, 30);
    inPlan(PLAN, "G1.1", entries / 2, 0);
    inPlan(SCRIPT_WITH_PLAN, "G1.1.1", entries / 2, 0);
    inPlan(PLAN, "G1.1", entries * 3 / 4, 0);
  }

  @Test
  @Tag("full")
  void everyEntryOfAScriptInAPlan() throws IOException {
    everyEntryInPlan(PLAN, "G1.1");
  }

  @Test
  @Tag("full")
  void everyEntryOfAScriptInThePlanOfAScript() throws IOException {
    everyEntryInPlan(SCRIPT_WITH_PLAN, "G1.1.1");
  }

  private void everyEntryInPlan(String goal, String script) throws IOException {
    int entries = entriesOfScriptInPlan(goal);
    for (long at : Share.of(LongStream.rangeClosed(1, entries)).toArray()) {
      inPlan(goal, script, (int) at, 0);
      inPlan(goal, script, (int) at, (int) (1 + at % 60));
    }
  }

  private static Home homeWithComposite() throws IOException {
    return new HomeLoader()
        .load(
            text("/homes/bob.ttl")
                + """

                home:ready a maestro:Predicate ; rdfs:label "ready" ; maestro:arguments ( "?room - Zone" ) .
                home:prepare a maestro:Script ; rdfs:label "have a room ready" ;
                  maestro:arguments ( "?room - Zone" ) ; maestro:effect "(ready ?room)" ; maestro:cost 10 ;
                  maestro:body "(seq (tell CCA (begun (:room ?room))) (achieve (>= (illuminance ?room) 72)) (achieve (in rose zone-a)) (tell CCA (almost (:room ?room))) (assert (ready ?room)))" .
                home:visit a maestro:Script ; rdfs:label "have a visitor" ;
                  maestro:body "(seq (achieve (ready zone-b)) (achieve (nextTo Cup Bob)))" .
                """,
            "bob.ttl");
  }

  private static void prepared(MortalSite site, String goal) {
    site.clock.runUntil(() -> site.isDead() || site.allPresent(), Duration.ofMinutes(1));
    site.submit(goal);
    site.clock.runUntil(
        () -> site.isDead() || site.accepted.size() == 1 && site.allEnded(),
        Duration.ofMinutes(20));
  }

  private int entriesOfScriptInPlan(String goal) throws IOException {
    try (MortalSite site =
        new MortalSite(
            homeWithComposite(), scene, directory.resolve("composite" + goal.length()))) {
      site.begin(Integer.MAX_VALUE);
      prepared(site, goal);
      assertThat(site.story.toString()).contains("the script prepare is run for zone-b");
      assertThat(site.outcomes.values())
          .as(site.story.toString())
          .allMatch(outcome -> outcome.reached());
      return site.written();
    }
  }

  /**
   * The script goes on where it was, and then its goal. What it had asserted nobody knows after the
   * end of the process, so it is run once more for that.
   */
  private void inPlan(String goal, String script, int at, int torn) throws IOException {
    Path data = directory.resolve(script + "-" + at + "-" + torn);
    try (MortalSite site = new MortalSite(homeWithComposite(), scene, data)) {
      site.begin(at);
      prepared(site, goal);
      boolean accepted = !site.accepted.isEmpty();
      if (torn > 0) {
        site.tear(torn);
      }
      List<String> left = Files.readAllLines(data.resolve("journal.jsonl"));
      site.clock.run(Duration.ofMillis(100L * (at % 50)));
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(() -> site.allPresent() && site.allEnded(), Duration.ofMinutes(20));
      String context =
          "died at %d, torn by %d%n%s%n%s"
              .formatted(
                  at,
                  torn,
                  Files.readString(data.resolve("journal.jsonl")),
                  site.story.stream().map(String::valueOf).collect(Collectors.joining("\n")));
      assertThat(site.allEnded()).as(context).isTrue();
      assertThat(site.outcomes.values()).as(context).allMatch(outcome -> outcome.reached());
      assertThat(site.witness.executedTwice()).as(context).isEmpty();
      List<String> letters =
          List.of(script + ".1 (begun (:room zone-b))", script + ".4 (almost (:room zone-b))");
      if (accepted && !isNoted(script + ".5 (ready zone-b)", left)) {
        assertThat(new LinkedHashSet<>(site.letters))
            .as(context)
            .containsExactlyElementsOf(letters);
        for (String letter : letters) {
          assertThat(Collections.frequency(site.letters, letter))
              .as(letter + "\n" + context)
              .isLessThanOrEqualTo(isNoted(letter, left) ? 1 : 2);
        }
      }
    }
  }

  /** Whether the journal has it that the part is over by which the letter was sent. */
  private static boolean isNoted(String letter, List<String> journal) {
    String part = letter.substring(0, letter.indexOf(' '));
    int dot = part.lastIndexOf('.');
    return journal.stream()
        .filter(line -> line.contains("\"noted\"") && line.endsWith("}"))
        .filter(line -> line.contains("\"" + part.substring(0, dot) + "\""))
        .anyMatch(line -> line.contains("\"path\":\"" + part.substring(dot + 1) + "\""));
  }

  /** The time for which nobody is there counts. */
  @Test
  void aWaitIsOverWhenItWouldHaveBeen() throws IOException {
    Body body = SlParser.body("(wait 300)", home.vocabulary()::isFluent);
    Home waiting = home.withScripts(Map.of("rest", script("rest", List.of(), body)));
    try (MortalSite site = new MortalSite(waiting, scene, directory.resolve("wait"))) {
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(site::allPresent, Duration.ofMinutes(1));
      Duration stated = site.clock.now();
      site.submit("(rest)");
      site.clock.run(Duration.ofSeconds(100));
      site.die();
      site.clock.run(Duration.ofSeconds(100));
      site.begin(Integer.MAX_VALUE);
      assertThat(site.allEnded()).isFalse();
      site.clock.runUntil(site::allEnded, Duration.ofMinutes(20));

      assertThat(site.clock.now().minus(stated))
          .as(site.story.toString())
          .isBetween(Duration.ofSeconds(299), Duration.ofSeconds(302));
    }
  }

  @Test
  void someEntriesOfAHeldGoal() throws IOException {
    int entries = entriesUntilHeld();
    assertThat(entries).isGreaterThan(20);
    hold(entries / 2, 30);
    hold(entries, 0);
  }

  @Test
  @Tag("full")
  void everyEntryOfAHeldGoal() throws IOException {
    int entries = entriesUntilHeld();
    for (long at : Share.of(LongStream.rangeClosed(1, entries)).toArray()) {
      hold((int) at, 0);
      hold((int) at, (int) (1 + at % 60));
    }
  }

  private int entriesUntilHeld() throws IOException {
    try (MortalSite site = new MortalSite(home, scene, directory.resolve("held"))) {
      site.begin(Integer.MAX_VALUE);
      untilHeld(site);
      assertThat(site.isHolding()).isTrue();
      return site.written();
    }
  }

  private static void untilHeld(MortalSite site) {
    site.clock.runUntil(() -> site.isDead() || site.allPresent(), Duration.ofMinutes(1));
    site.submit("(keep (>= (illuminance zone-b) 72))");
    site.clock.runUntil(() -> site.isDead() || site.isHolding(), Duration.ofMinutes(5));
  }

  /** The next one holds it, and dims lamps that the one before has lit. */
  private void hold(int at, int torn) throws IOException {
    Path data = directory.resolve("hold-" + at + "-" + torn);
    try (MortalSite site = new MortalSite(home, scene, data)) {
      site.begin(at);
      untilHeld(site);
      boolean accepted = !site.accepted.isEmpty();
      if (torn > 0) {
        site.tear(torn);
      }
      site.begin(Integer.MAX_VALUE);
      site.clock.runUntil(site::isHolding, Duration.ofMinutes(5));
      String context = "died at %d, torn by %d: %s".formatted(at, torn, site.story);
      if (accepted) {
        assertThat(site.isHolding()).as(context).isTrue();
        assertThat(site.world().lux("zone-b")).as(context).isGreaterThanOrEqualTo(72);
        site.world().setAmbient("zone-b", 100);
        boolean dimmed =
            site.clock.runUntil(() -> site.world().lux("zone-b") < 101, Duration.ofMinutes(5));
        assertThat(dimmed).as(context).isTrue();
      }
      assertThat(site.witness.executedTwice()).as(context).isEmpty();
    }
  }
}

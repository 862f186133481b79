package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Script;
import org.maestro.sl.SlParser;

/** What scripts say to people, and tell agents. */
class SpeechTest {
  private static Home home;

  private final Map<String, Script> scripts = new TreeMap<>();
  private NarrowHouse house;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = SpeechTest.class.getResourceAsStream("/narrow.ttl")) {
      home =
          new HomeLoader()
              .load(
                  new String(turtle.readAllBytes(), StandardCharsets.UTF_8)
                      + "\nhome:Bob a :Person ; rdfs:label \"Bob\"@en .\n",
                  "narrow.ttl");
    }
  }

  private void script(String name, String body) {
    scripts.put(
        name,
        new Script(
            name,
            List.of(SlParser.variable("?who - Person")),
            SlParser.body(body, home.vocabulary()::isFluent)));
  }

  private GoalOutcome run(String body, String... deaf) {
    script("speak", body);
    house = new NarrowHouse(home.withScripts(scripts), 1).with("rose", "zone-a");
    house.letters.deaf.addAll(List.of(deaf));
    String id = house.wish("(speak Bob)");
    house.run(1, Duration.ofMinutes(10));
    return house.outcomes.get(id);
  }

  @Test
  void whatIsSaidIsMadeOfTextsAndOfThingsAndNumbersAsPeopleCallThem() {
    GoalOutcome outcome =
        run("(let ?lux (value (/ 500 7)) (say ?who \"Hello,\" ?who \", it is\" ?lux \"lux.\"))");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(outcome.confirmed()).isTrue();
    assertThat(house.letters.said)
        .containsExactly(new Speech("G1.1.2.1", "Bob", "Hello, Bob, it is 71.43 lux."));
    assertThat(house.letters.said.get(0).goalId()).isEqualTo("G1");
    assertThat(house.told()).contains("G1 SAID [1.2.1] To Bob: \"Hello, Bob, it is 71.43 lux.\"");
  }

  @Test
  void anAgentIsToldAMessageWithWhatTheVariablesStandForAndWhatIsOpenLeftOpen() {
    assertThat(
            run("(seq (tell CCA (initCNP (:goal (nextTo Cup ?who)) (:priority 2)))"
                    + " (tell \"livingroom\" (query-ref (in ?thing zone-a) (note ?who))))")
                .reached())
        .isTrue();

    assertThat(house.letters.told)
        .containsExactly(
            "G1.1 CCA (initCNP (:goal (nextTo Cup Bob)) (:priority 2))",
            "G1.2 livingroom (query-ref (in ?thing zone-a) (note Bob))");
    assertThat(house.told()).contains("G1 SAID [1] The agent CCA is told (initCNP");
  }

  @Test
  void whoTakesNothingIsAReasonToFail() {
    GoalOutcome outcome = run("(say ?who \"Hello.\")", "Bob");
    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.reasons()).containsExactly("Bob is deaf.");
    assertThat(house.told()).doesNotContain("SAID");

    assertThat(
            run("(try (tell CCA (ping)) (recover \"deaf\" (say ?who \"Nobody is there.\")))", "CCA")
                .reached())
        .isTrue();
    assertThat(house.letters.said).hasSize(1);
  }

  @Test
  void aMoodIsShownWithAWordAndANumberThatIsReckoned() {
    assertThat(
            run("(let ?n (value (/ 1 4)) (seq (express glad ?n) (express \"at ease\" 1)"
                    + " (let ?m (value 7) (try (express glad ?m)"
                    + " (recover \"from 0 to 1\" (express cross 0))))))")
                .reached())
        .as(house.told())
        .isTrue();

    assertThat(house.letters.moods)
        .containsExactly(
            new Mood("G1.1.2.1.1", "glad", 0.25),
            new Mood("G1.1.2.1.2", "at ease", 1),
            new Mood("G1.1.2.1.3.2.1.3", "cross", 0));
    assertThat(house.told()).contains("SAID [1.2.1.1] Shows that it is glad, by 0.25.");
    assertThat(run("(express glad 1)", "everybody").reasons())
        .containsExactly("everybody is deaf.");
  }

  /** To say something takes no time: a round of nothing else waits until there is news. */
  @Test
  void whoSaysTheSameAgainAndAgainWaitsForNews() {
    script("speak", "(while (in rose zone-a) (say ?who \"It is here.\"))");
    house = new NarrowHouse(home.withScripts(scripts), 1).with("rose", "zone-a");
    house.wish("(speak Bob)");
    house.clock.run(Duration.ofMinutes(5));
    assertThat(house.letters.said).hasSize(1);

    house.with("rose", "zone-b");
    house.run(1, Duration.ofMinutes(1));
    assertThat(house.outcomes.get("G1").reached()).as(house.told()).isTrue();
    assertThat(house.letters.said).hasSize(1);
  }
}

package org.maestro.console.history;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is recorded of the events that pages are told. */
class RecorderTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final Instant START = Instant.parse("2026-01-01T12:00:00Z");
  private static final double SPEED = 20;

  private final Archive archive =
      new Archive(
          new Archive.Limits(1 << 20, Duration.ofDays(1), 100_000), new DiskCopy(Optional.empty()));
  private Duration passed = Duration.ZERO;
  private final Recorder recorder =
      new Recorder(
          archive, () -> START.plus(passed), () -> passed.multipliedBy((long) SPEED), SPEED);

  @BeforeEach
  void begin() {
    recorder.begin();
  }

  private void tell(String event, String document) {
    try {
      passed = passed.plusSeconds(1);
      recorder.take(event, MAPPER.readTree(document.replace('\'', '"')));
    } catch (JsonProcessingException e) {
      throw new AssertionError(e);
    }
  }

  private void goal(String state) {
    tell(
        "goals",
        "{'goals': [{'id': 'G1', 'goal': '(in Cup x)', 'state': '%s', 'age_s': %s}]}"
            .formatted(state, passed.toSeconds() * SPEED));
  }

  private void lamp(String phase, double age) {
    tell(
        "agents",
        "{'agents': [{'agent': 'lamp', 'members': ['lamp'], 'phase': '%s', 'why': null, 'age_s': %s}]}"
            .formatted(phase, age));
  }

  private List<String> happened() {
    return archive.happenings(START, START.plusSeconds(1_000)).stream()
        .map(one -> one.told().path("name").asText() + " " + one.told().path("what").asText())
        .toList();
  }

  @Test
  void whatBecomesOfAGoalIsToldOnce() {
    List.of("submitted", "planning", "running", "running", "confirming", "achieved", "achieved")
        .forEach(this::goal);
    tell("story", "{'goal': 'G1', 'kind': 'plan', 'text': 'Plan 1'}");
    tell("story", "{'goal': 'G1', 'kind': 'replan', 'text': 'The door is shut.'}");

    assertThat(happened()).containsExactly("G1 stated", "G1 begun", "G1 reached", "G1 replanned");
  }

  @Test
  void whoGoesBackToAnEventSeesWhatCameOfIt() {
    goal("submitted");

    Instant stated = archive.happenings(START, START.plusSeconds(9)).get(0).at();
    assertThat(archive.until(stated).orElseThrow().document(stated).at("/goals/0/state").asText())
        .isEqualTo("submitted");
  }

  @Test
  void aGoalThatIsOlderThanTheRecordIsNotStatedAgain() {
    passed = Duration.ofSeconds(500);
    goal("running");
    goal("failed");

    assertThat(happened()).containsExactly("G1 failed");
  }

  @Test
  void whatBecomesOfAMemberIsTold() {
    lamp("absent", 0);
    lamp("ready", 0);
    lamp("ready", 20);
    lamp("lost", 0);
    lamp("ready", 0);
    lamp("refused", 0);

    assertThat(happened())
        .containsExactly("lamp joined", "lamp lost", "lamp returned", "lamp refused");
  }

  @Test
  void onlyWhatHasChangedIsRecorded() {
    lamp("ready", 0);
    long weight = archive.weight();
    lamp("ready", 20);
    lamp("ready", 40);

    assertThat(archive.weight()).isEqualTo(weight);
  }

  @Test
  void sightingsAreCountedByThePlatformsClock() {
    for (int i = 0; i < 3; i++) {
      tell(
          "facts",
          ("{'all': false, 'gone': [], 'facts': [{'fact': '(canSee cam Cup)', 'word': 'canSee',"
                  + " 'arguments': ['cam', 'Cup'], 'value': true, 'kind': 'observed',"
                  + " 'since': '%d'}, {'fact': '(not (canSee cam Bob))', 'word': 'canSee',"
                  + " 'arguments': ['cam', 'Bob'], 'value': false, 'kind': 'observed'}]}")
              .formatted(i));
    }
    recorder.answered(Answerer.API, Duration.ofMillis(2));
    recorder.answered(Answerer.API, Duration.ofMillis(4));
    recorder.measure();
    passed = passed.plusSeconds(10);
    recorder.measure();

    assertThat(archive.samples(List.of("detections")).get("detections"))
        .extracting(Sample::mean)
        .as("three in three seconds of the wall, which are a minute")
        .containsExactly(3.0, 0.0);
    List<Sample> answers = archive.samples(List.of("api-answers")).get("api-answers");
    assertThat(answers.get(0)).isEqualTo(new Sample(START.plusSeconds(3).toEpochMilli(), 2, 3, 4));
    assertThat(answers.get(1).isKnown()).as("nothing was asked").isFalse();
  }
}

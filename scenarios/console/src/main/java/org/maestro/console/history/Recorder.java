package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.time.InstantSource;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Supplier;

/**
 * Records what pages are told: of facts, goals and agents what has changed, what became of goals
 * and members, and some figures. One thread tells it; any thread may say how long something took.
 */
final class Recorder {
  private static final double MINUTE = 60;

  private final Archive archive;
  private final InstantSource wall;
  private final Supplier<Duration> clock;
  private final double speed;
  private final Map<Answerer, Stopwatch> answers = new EnumMap<>(Answerer.class);
  private int detections;
  private double measuredUntil;

  /**
   * @param clock simulated time since the platform's clock began
   * @param speed simulated seconds in one of wall time
   */
  Recorder(Archive archive, InstantSource wall, Supplier<Duration> clock, double speed) {
    this.archive = archive;
    this.wall = wall;
    this.clock = clock;
    this.speed = speed;
    for (Answerer answerer : Answerer.values()) {
      answers.put(answerer, new Stopwatch());
    }
  }

  /** After what was recorded before. */
  void begin() {
    archive.read();
    archive.begin(wall.instant(), seconds(), speed);
    measuredUntil = seconds();
  }

  private double seconds() {
    return clock.get().toMillis() / 1000.0;
  }

  /** One event of those that pages are told. */
  void take(String event, JsonNode document) {
    PastState state = archive.state();
    switch (event) {
      case "home" -> add(Entry.Kind.HOME, document);
      case "facts" -> takeFacts(document);
      case "goals" -> {
        ObjectNode change = state.goals().change(document.path("goals"));
        List<ObjectNode> happened = Happenings.ofGoals(change, state.goals(), speed);
        addChange(Entry.Kind.GOALS, change);
        happened.forEach(one -> add(Entry.Kind.HAPPENING, one));
      }
      case "agents" -> {
        ObjectNode change = state.agents().change(document.path("agents"));
        List<ObjectNode> happened = Happenings.ofAgents(change, state.agents(), speed);
        addChange(Entry.Kind.AGENTS, change);
        happened.forEach(one -> add(Entry.Kind.HAPPENING, one));
      }
      case "story" -> Happenings.ofStory(document).ifPresent(one -> add(Entry.Kind.HAPPENING, one));
      default -> {
        // Others are for listeners alone.
      }
    }
  }

  private void takeFacts(JsonNode document) {
    ObjectNode change = JsonNodeFactory.instance.objectNode();
    if (document.path("all").asBoolean()) {
      change = archive.state().facts().change(document.path("facts"));
    } else {
      change.set("set", document.path("facts"));
      change.set("gone", document.path("gone"));
    }
    for (JsonNode fact : change.path("set")) {
      detections += isDetection(fact) ? 1 : 0;
    }
    addChange(Entry.Kind.FACTS, change);
  }

  /** Somebody has seen something, for the first time or again. */
  private static boolean isDetection(JsonNode fact) {
    return fact.path("word").asText().equals("canSee")
        && fact.path("value").asBoolean()
        && fact.path("kind").asText().equals("observed");
  }

  private void addChange(Entry.Kind kind, ObjectNode change) {
    if (!change.path("set").isEmpty() || !change.path("gone").isEmpty()) {
      add(kind, change);
    }
  }

  private void add(Entry.Kind kind, JsonNode told) {
    archive.add(new Entry(wall.instant(), seconds(), kind, told));
  }

  /** Some seconds have passed. */
  void measure() {
    double now = seconds();
    ObjectNode figures = JsonNodeFactory.instance.objectNode();
    double rate = now > measuredUntil ? detections / (now - measuredUntil) * MINUTE : 0;
    figures.putArray("detections").add(rate).add(rate).add(rate);
    answers.forEach((answerer, watch) -> figures.set(answerer.series(), watch.look()));
    detections = 0;
    measuredUntil = now;
    add(Entry.Kind.FIGURES, figures);
  }

  /** Somebody has answered. */
  void answered(Answerer answerer, Duration after) {
    Objects.requireNonNull(answers.get(answerer)).took(after);
  }
}

package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.imageio.ImageIO;
import org.maestro.assembly.LocalSite;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.TimeChart;
import org.maestro.ontology.floor.Point2;
import org.maestro.sl.SlParser;

/**
 * An evening of a robot that is to clean, and not to disturb (ADE, 4.1; A56): scripts that never
 * end contend for it by what they are worth. What it did is judged from where it was in the
 * simulated world. One thread.
 */
final class HousekeeperEvening {
  static final String HOME = "housekeeper";
  static final String SCENE = "housekeeper";

  private static final String PERSON = "Dave";
  private static final String ROBOT = "rosie";
  private static final String SPILLED = "(spilled kitchen)";
  private static final Duration STEP = Duration.ofSeconds(1);
  private static final Duration PATIENCE = Duration.ofMinutes(1);

  private static final double COMES = 60;

  private static final double CALLS = 120;
  private static final double LEAVES = 200;
  private static final double ENDS = 270;

  /** A room is swept to its end, at a safe point. */
  private static final double AT_MOST_A_ROOM = 25;

  private static final double LEAST_METRES = 1;
  private static final double STANDS_METRES = 0.01;

  private final LocalSite site;
  private final Optional<PrintWriter> out;
  private final AclQuestions questions;
  private final Map<String, TimeChart.Series> curves = new LinkedHashMap<>();
  private final List<Place> places = new ArrayList<>();
  private final AtomicBoolean isOver = new AtomicBoolean();
  private final Duration began;

  /** Where it was, in the world; seconds. */
  private record Place(double at, Point2 point) {}

  /** What it has to have done between two moments. */
  private record Span(String what, double from, double to, boolean isToDrive, double metres) {
    boolean isRight() {
      return isToDrive ? metres >= LEAST_METRES : metres <= STANDS_METRES;
    }

    String sentence() {
      return String.format(
          Locale.ROOT,
          "%-46s %3.0f to %3.0f s: it %s (%.1f m)",
          what,
          from,
          to,
          metres <= STANDS_METRES ? "stood still" : "drove",
          metres);
    }
  }

  /**
   * @param out where it is told as it happens, if anywhere
   */
  HousekeeperEvening(LocalSite site, Optional<PrintWriter> out) {
    this.site = site;
    this.out = out;
    this.questions = new AclQuestions(site.platform().desk());
    this.began = site.clock().now();
    curve("(keepStill)", Ink.BLUE);
    curve("(clean kitchen)", Ink.RED);
    curve("(clean living)", Ink.ORANGE);
  }

  private void curve(String script, Ink ink) {
    curves.put(script, new TimeChart.Series(script, ink, new ArrayList<>()));
  }

  void run() {
    out.ifPresent(
        where -> {
          StoryPrinter printer = new StoryPrinter(where, began);
          site.platform()
              .onStory(
                  entry -> {
                    if (!isOver.get()) {
                      print(entry, printer);
                    }
                  });
        });
    curves.keySet().forEach(this::state);
    Deque<Event> events =
        new ArrayDeque<>(
            List.of(
                new Event(COMES, () -> site.world().hide(PERSON, false)),
                new Event(CALLS, () -> state(SPILLED)),
                new Event(LEAVES, () -> site.world().hide(PERSON, true))));
    while (seconds() < ENDS) {
      site.runUntil(() -> false, STEP);
      if (!events.isEmpty() && seconds() >= events.element().at()) {
        events.remove().happens().run();
      }
      sample();
    }
    isOver.set(true);
  }

  private record Event(double at, Runnable happens) {}

  private double seconds() {
    return site.clock().now().minus(began).toMillis() / 1000.0;
  }

  private void state(String script) {
    site.platform().desk().pursue(SlParser.formula(script), id -> {}, report -> {});
  }

  /** Who waits for whom, and what is swept: enough to follow it. */
  private static void print(StoryEntry entry, StoryPrinter printer) {
    boolean isSweeping = entry.kind() == StoryEntry.Kind.STEP && entry.text().contains("sweeps");
    if (isSweeping
        || entry.kind() == StoryEntry.Kind.WAIT
        || entry.kind() == StoryEntry.Kind.LEARNT) {
      printer.print(
          new StoryEntry(
              entry.goalId(), entry.at(), entry.kind(), entry.goalId() + " " + entry.text()));
    }
  }

  private void sample() {
    places.add(new Place(seconds(), site.world().position(ROBOT).orElseThrow().floor()));
    CompletableFuture<JsonNode> asked = questions.goals();
    if (!site.runUntil(asked::isDone, PATIENCE)) {
      throw CommandException.outside("The platform does not tell its goals.");
    }
    double now = seconds();
    for (JsonNode goal : asked.join().path("goals")) {
      JsonNode weight = goal.path("worth").path("weight");
      if (curves.containsKey(goal.path("goal").asText()) && weight.isNumber()) {
        curves.get(goal.path("goal").asText()).points().add(new double[] {now, weight.asDouble()});
      }
    }
  }

  private List<Span> spans() {
    return List.of(
        span("Nobody is at home: it cleans.", 0, COMES, true),
        span(
            "Dave is there: it has ended a room, and stands.",
            COMES + AT_MOST_A_ROOM,
            CALLS,
            false),
        span("Something was spilled: it cleans all the same.", CALLS, CALLS + AT_MOST_A_ROOM, true),
        span("That is done: it stands again.", CALLS + 2 * AT_MOST_A_ROOM, LEAVES, false),
        span("Dave has left: it goes on cleaning.", LEAVES, ENDS, true));
  }

  private Span span(String what, double from, double to, boolean isToDrive) {
    double metres = 0;
    for (int i = 1; i < places.size(); i++) {
      if (places.get(i - 1).at() >= from && places.get(i).at() <= to) {
        metres += places.get(i).point().distance(places.get(i - 1).point());
      }
    }
    return new Span(what, from, to, isToDrive, metres);
  }

  boolean wentWell() {
    return spans().stream().allMatch(Span::isRight);
  }

  /** The priorities over time, u·g of each. */
  Path draw(Path picture) {
    try {
      ImageIO.write(
          TimeChart.draw(
              "Cleaning and keeping still",
              "priority u·g",
              List.copyOf(curves.values()),
              List.of(
                  new TimeChart.Event(COMES, "Dave comes"),
                  new TimeChart.Event(CALLS, "he calls: a spill"),
                  new TimeChart.Event(LEAVES, "Dave leaves"))),
          "png",
          picture.toFile());
      return picture;
    } catch (IOException e) {
      throw CommandException.outside("The picture cannot be written to " + picture + ".", e);
    }
  }

  void tell(Path picture, PrintWriter to) {
    to.println();
    spans().forEach(span -> to.println((span.isRight() ? "yes  " : "no   ") + span.sentence()));
    to.println();
    to.println("The priorities over time: " + picture);
    to.println();
    to.println("Try next:");
    to.println("  ./maestro why G1           why it stood still, and why it did not");
    to.println("  ./maestro run housekeeper  the same, to talk to: run-script spilled kitchen");
  }

  String document(Path picture) {
    JsonMembers document = JsonMembers.empty().truth("reached", wentWell());
    for (Span span : spans()) {
      JsonMembers.in(document.node().withArray("spans"))
          .text("what", span.what)
          .number("from_s", span.from)
          .number("to_s", span.to)
          .number("metres", Math.round(span.metres * 100) / 100.0)
          .truth("as_wanted", span.isRight());
    }
    return document.text("picture", picture.toString()).toString();
  }
}

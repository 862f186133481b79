package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.maestro.console.documents.StoryDocument;
import org.maestro.coordination.api.StoryEntry;

/**
 * The way of one utterance through a running platform, word by word, with the numbers that figure 3
 * of the ADE paper gives to its stations (A51). One thread only.
 */
final class SpokenTrace {
  private static final long LOOK_EVERY_MILLIS = 200;
  private static final double MILLIS_PER_SECOND = 1_000;

  private final AskedPlatform asked;
  private final String person;
  private final String room;
  private final PrintWriter out;
  private final Map<String, Integer> toldByGoal = new HashMap<>();
  private final Set<String> undone = new LinkedHashSet<>();
  private final Set<String> looks = new LinkedHashSet<>();
  private OptionalDouble began = OptionalDouble.empty();
  private boolean nods;
  private long latest;
  private long slowestWord;
  private int code = ExitCode.DONE;

  SpokenTrace(AskedPlatform asked, String person, String room, PrintWriter out) {
    this.asked = asked;
    this.person = person;
    this.room = room;
    this.out = out;
  }

  /**
   * Says the words one by one, and follows what they state until it is over.
   *
   * @param secondsPerWord from one to the next
   * @return the exit code
   */
  int say(List<String> words, double secondsPerWord) throws InterruptedException {
    List<String> said = new ArrayList<>();
    for (String word : words) {
      said.add(word);
      hear(word, heard(said, true));
      slowestWord = Math.max(slowestWord, latest);
      pause(Math.round(secondsPerWord * MILLIS_PER_SECOND));
      toldByGoal.keySet().forEach(this::follow);
    }
    end(heard(said, false));
    long whole = latest;
    while (toldByGoal.values().stream().anyMatch(told -> told >= 0)) {
      pause(LOOK_EVERY_MILLIS);
      toldByGoal.keySet().forEach(this::follow);
    }
    out.println();
    out.println(
        "1 word, 2 goal begun or taken back, 3 look, 4 nod, 5 message, 6 goals, 8 steps, 9 answer:"
            + " the numbers of figure 3 of the ADE paper, seconds since the first word.");
    out.printf(
        Locale.ROOT,
        "Answered %d ms after a word at most, %d ms after the whole; wall time.%n",
        slowestWord,
        whole);
    return code;
  }

  private JsonNode heard(List<String> said, boolean more) {
    long asking = System.nanoTime();
    JsonNode heard =
        asked.answer(questions -> questions.hear(person, room, String.join(" ", said), more));
    latest = TimeUnit.NANOSECONDS.toMillis(System.nanoTime() - asking);
    return heard;
  }

  private static void pause(long millis) throws InterruptedException {
    new CountDownLatch(1).await(millis, TimeUnit.MILLISECONDS);
  }

  private void hear(String word, JsonNode heard) {
    double at = heard.path("at_s").asDouble();
    began = OptionalDouble.of(began.orElse(at));
    tell(at, 1, word);
    if (heard.has("refused")) {
      tell(at, 9, heard.path("refused").asText());
      code = ExitCode.BAD_INPUT;
      return;
    }
    for (JsonNode goal : heard.path("undone")) {
      if (undone.add(goal.asText())) {
        tell(at, 2, goal.asText() + " is called off, and what it has changed is undone");
      }
    }
    for (JsonNode goal : heard.path("begun")) {
      if (!toldByGoal.containsKey(goal.asText())) {
        toldByGoal.put(goal.asText(), 0);
        tell(at, 2, goal.asText() + " is begun");
      }
    }
    for (JsonNode thing : heard.path("looks")) {
      if (looks.add(thing.asText())) {
        tell(at, 3, "looks at " + thing.asText());
      }
    }
    if (heard.path("nods").asBoolean() && !nods) {
      tell(at, 4, "nods");
    }
    nods = heard.path("nods").asBoolean();
  }

  private void end(JsonNode heard) {
    double at = heard.path("at_s").asDouble();
    if (heard.has("means")) {
      tell(at, 5, heard.path("means").asText());
    }
    for (JsonNode goal : heard.path("goals")) {
      toldByGoal.putIfAbsent(goal.asText(), 0);
      tell(at, 6, goal.asText());
    }
    for (String answer : List.of("reply", "asks", "refused")) {
      if (heard.has(answer)) {
        tell(at, 9, heard.path(answer).asText());
      }
    }
    code = heard.has("refused") ? ExitCode.BAD_INPUT : code;
  }

  /** Steps and the end of a goal that have not been told; it is told no more after its end. */
  private void follow(String goal) {
    int told = toldByGoal.getOrDefault(goal, -1);
    if (told < 0) {
      return;
    }
    List<StoryEntry> story =
        StoryDocument.read(
            asked.answer(
                questions -> questions.story(goal, OptionalInt.empty(), OptionalInt.empty())));
    for (StoryEntry entry : story.subList(Math.min(told, story.size()), story.size())) {
      double at = entry.at().toMillis() / MILLIS_PER_SECOND;
      if (entry.kind() == StoryEntry.Kind.STEP) {
        tell(at, 8, entry.text());
      } else if (entry.kind() == StoryEntry.Kind.END && !undone.contains(goal)) {
        tell(at, 9, entry.text());
      }
    }
    boolean isOver = story.stream().anyMatch(entry -> entry.kind() == StoryEntry.Kind.END);
    toldByGoal.put(goal, isOver ? -1 : story.size());
  }

  private void tell(double at, int station, String what) {
    out.printf(Locale.ROOT, "%7.2f  %2d  %s%n", at - began.orElse(at), station, what);
    out.flush();
  }
}

package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/**
 * A person's conversation with a running platform: what she says goes there, and what becomes of
 * it, and what she is told besides, comes as lines. One thread only.
 */
final class Conversing {
  /** So often nothing new has to come after an answer; then it was the whole. */
  private static final int QUIET_LOOKS = 3;

  private final AskedPlatform asked;
  private final String person;
  private final String room;
  private final Optional<String> language;
  private final Consumer<String> lines;
  private final Set<String> pursued = new LinkedHashSet<>();
  private int code = ExitCode.DONE;
  private boolean answered = true;
  private int quiet = QUIET_LOOKS;
  private long last;

  /**
   * @param language in which it is said; empty: that which is usual for her
   * @param lines takes what she is told
   */
  Conversing(
      AskedPlatform asked,
      String person,
      String room,
      Optional<String> language,
      Consumer<String> lines) {
    this.asked = asked;
    this.person = person;
    this.room = room;
    this.language = language;
    this.lines = lines;
  }

  /** Only what is said from now on is heard. */
  void begin() {
    asked
        .answer(questions -> questions.said(0))
        .path("entries")
        .forEach(entry -> last = Math.max(last, entry.path("number").asLong()));
  }

  /**
   * Says something.
   *
   * @throws CommandException when it is refused, or nobody answers
   */
  void say(String text) {
    long number =
        asked
            .answer(questions -> questions.say(person, room, text, language))
            .path("number")
            .asLong();
    // What she was told before it is not passed over.
    last = last == 0 ? number : last;
    answered = false;
    quiet = 0;
  }

  /**
   * Tells what has come since.
   *
   * @throws CommandException when nobody answers
   */
  void look() {
    long seen = last;
    for (JsonNode entry : asked.answer(questions -> questions.said(seen)).path("entries")) {
      last = Math.max(last, entry.path("number").asLong());
      if (isForHer(entry)) {
        tell(entry);
      }
    }
    quiet = last == seen ? Math.min(quiet + 1, QUIET_LOOKS) : 0;
  }

  private boolean isForHer(JsonNode entry) {
    String to = entry.path("person").asText("");
    return to.equals(person) || to.isEmpty() && entry.path("room").asText("").equals(room);
  }

  private void tell(JsonNode entry) {
    String goal = entry.path("goal").asText("");
    String text = entry.path("text").asText();
    switch (entry.path("kind").asText()) {
      case "understood" -> {
        pursued.add(goal);
        answered = true;
        // What is stated in MAESTRO-SL is asked about by its id, what is said by saying so.
        lines.accept(text.startsWith("(") ? goal + ": " + text : text);
      }
      case "reached", "ended" -> {
        if (pursued.remove(goal) && entry.path("kind").asText().equals("ended")) {
          code = ExitCode.NOT_REACHED;
        }
        lines.accept(text);
      }
      case "misunderstood" -> {
        answered = true;
        code = ExitCode.BAD_INPUT;
        lines.accept(text);
      }
      case "said", "answered" -> {
        // One's own words, and those of who speaks as the same person elsewhere.
      }
      default -> {
        answered = answered || goal.isEmpty();
        lines.accept(text);
        WantedAnswers.of(entry).forEach(lines);
      }
    }
  }

  /** Whether all that was said is answered, and nothing more comes of it for the moment. */
  boolean isAnswered() {
    return answered && quiet >= QUIET_LOOKS;
  }

  /** Whether goals that were said are under way. */
  boolean isPursued() {
    return !pursued.isEmpty();
  }

  /** What the shell is told. */
  int code() {
    return code;
  }
}

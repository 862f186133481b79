package org.maestro.console.chat;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.Mood;
import org.maestro.coordination.api.Speech;
import org.maestro.dialogue.Utterance;
import org.maestro.sl.SlPrinter;

/**
 * Something that was said in a conversation.
 *
 * @param person whose conversation it is
 * @param room in which she was when she said what it belongs to
 * @param kind of it, in a word
 * @param goal of which it tells
 * @param near what could be said instead, or as an answer
 * @param question the part of a script that asks, where one does, or is answered
 * @param wanted the answer that it wants, while it asks
 */
record ChatEntry(
    Instant at,
    String person,
    String room,
    String kind,
    Optional<String> goal,
    String text,
    List<String> near,
    Optional<String> question,
    Optional<Speech.Wanted> wanted) {
  private static final long WEIGHT_OF_THE_REST = 100;

  static ChatEntry said(Utterance utterance, Instant at) {
    return entry(utterance, at, "said", Optional.empty(), utterance.text(), List.of());
  }

  static ChatEntry of(ChatEvent event, Utterance utterance, Instant at) {
    if (event instanceof ChatEvent.Understood understood) {
      Optional<String> goal = Optional.of(understood.goal());
      return entry(utterance, at, "understood", goal, understood.text(), List.of());
    }
    if (event instanceof ChatEvent.Told told) {
      Optional<String> goal = Optional.of(told.goal()).filter(id -> !id.isEmpty());
      return entry(utterance, at, "told", goal, told.text(), List.of());
    }
    if (event instanceof ChatEvent.Asked asked) {
      return entry(utterance, at, "asked", Optional.empty(), asked.text(), asked.choices());
    }
    if (event instanceof ChatEvent.Ended ended) {
      String kind = ended.reached() ? "reached" : "ended";
      return entry(utterance, at, kind, Optional.of(ended.goal()), ended.text(), List.of());
    }
    ChatEvent.Misunderstood wrong = (ChatEvent.Misunderstood) event;
    return entry(utterance, at, "misunderstood", Optional.empty(), wrong.text(), wrong.near());
  }

  /**
   * What a script says, or asks.
   *
   * @param person to whom; "" to all who are in the room
   * @param room in which; "" wherever the person is
   */
  static ChatEntry spoken(Speech speech, String person, String room, Instant at) {
    return new ChatEntry(
        at,
        person,
        room,
        speech.wanted().isPresent() ? "asked" : "spoken",
        Optional.of(speech.goalId()),
        speech.text(),
        speech.wanted().map(Speech.Wanted::choices).orElse(List.of()),
        speech.wanted().map(wanted -> speech.part()),
        speech.wanted());
  }

  /** That a script has taken an answer, where its question was; what it is not all may read. */
  static ChatEntry answered(GivenAnswer answer, String person, String room, Instant at) {
    return new ChatEntry(
        at,
        person,
        room,
        "answered",
        Optional.of(GoalId.whole(answer.part())),
        "",
        List.of(),
        Optional.of(answer.part()),
        Optional.empty());
  }

  static ChatEntry shown(String agent, Mood mood, Instant at) {
    return new ChatEntry(
        at,
        "",
        "",
        "shown",
        Optional.of(mood.goalId()),
        "%s is %s, by %s.".formatted(agent, mood.word(), SlPrinter.print(mood.intensity())),
        List.of(),
        Optional.empty(),
        Optional.empty());
  }

  private static ChatEntry entry(
      Utterance utterance,
      Instant at,
      String kind,
      Optional<String> goal,
      String text,
      List<String> near) {
    return new ChatEntry(
        at,
        utterance.person(),
        utterance.room(),
        kind,
        goal,
        text,
        near,
        Optional.empty(),
        Optional.empty());
  }

  /** About as many characters as it takes. */
  long weight() {
    return WEIGHT_OF_THE_REST + text.length() + near.stream().mapToLong(String::length).sum();
  }
}

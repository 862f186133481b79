package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.dialogue.Utterance;
import org.maestro.sl.Content;

/**
 * What people say, and what is answered, in messages: {@code (say "turn on the light" (:by Dave)
 * (:in bedroom))}. It is answered as it is understood: {@code (say (:means "(initCNP ...)") (:goals
 * G1))} and later how these ended; {@code (inform (:means "(query-if ...)") (:reply "Yes."))};
 * {@code (inform (:asks "Which light do you mean?"))}.
 */
public final class SayWords {
  private SayWords() {}

  /** The request. */
  public static Content content(Utterance utterance) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.text(utterance.text()));
    arguments.add(Words.named("by", Words.name(utterance.person())));
    if (!utterance.room().isEmpty()) {
      arguments.add(Words.named("in", Words.name(utterance.room())));
    }
    utterance.asker().ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    return new Content("say", arguments);
  }

  /** The same of words after which others are to come; all that was said so far. */
  public static Content unfinished(Utterance utterance) {
    List<Content.Argument> arguments = new ArrayList<>(content(utterance).arguments());
    arguments.add(Words.named("more", Words.name("true")));
    return new Content("say", arguments);
  }

  /**
   * It was understood as goals, which are taken on.
   *
   * @param means the message that it was understood to be
   */
  public static Content takenOn(String means, List<String> goals) {
    return Words.content(
        "say",
        Words.named("means", Words.text(means)),
        Words.named("goals", goals.stream().map(Words::name).toList()));
  }

  /**
   * It was a question, or nothing that anything follows from.
   *
   * @param means the message that it was understood to be; "" of none
   */
  public static Content replied(String means, String reply) {
    List<Content.Argument> arguments = new ArrayList<>();
    if (!means.isEmpty()) {
      arguments.add(Words.named("means", Words.text(means)));
    }
    arguments.add(Words.named("reply", Words.text(reply)));
    return new Content("inform", arguments);
  }

  /**
   * What was answered.
   *
   * @param contents of one message, at least one
   */
  public static SaidReply read(List<Content> contents) {
    Words words = Words.of(contents.get(0));
    Optional<String> means = words.string("means");
    if (words.find("goals").isPresent()) {
      return new SaidReply.TakenOn(means.orElse(""), words.strings("goals"));
    }
    if (words.string("state").isPresent()) {
      return new SaidReply.Over(contents.stream().map(Words::print).map(GoalReport::read).toList());
    }
    return words
        .string("reply")
        .<SaidReply>map(text -> new SaidReply.Replied(means.orElse(""), text))
        .or(() -> words.string("asks").map(SaidReply.Asked::new))
        .or(() -> words.string("answered").map(SaidReply.Answered::new))
        .orElseGet(
            () ->
                new SaidReply.Refused(
                    words
                        .string("reason")
                        .or(() -> words.string("problem"))
                        .orElse("Nothing comes of that, and nobody says why.")));
  }

  /** What is asked back; whatever the same person says next may answer it. */
  public static Content asked(String question) {
    return Words.content("inform", Words.named("asks", Words.text(question)));
  }
}

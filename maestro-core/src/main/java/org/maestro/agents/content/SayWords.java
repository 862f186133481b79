package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.dialogue.SpokenWords;
import org.maestro.dialogue.Utterance;
import org.maestro.sl.Content;

/**
 * What people say, and what is answered, in messages: {@code (say "turn on the light" (:by Dave)
 * (:in bedroom))}. It is answered as it is understood: {@code (say (:means "(initCNP ...)") (:goals
 * G1))} and later how these ended; {@code (inform (:means "(query-if ...)") (:reply "Yes."))};
 * {@code (inform (:asks "Which light do you mean?"))}.
 */
public final class SayWords {
  private static final int MILLIS_PER_SECOND = 1_000;

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
    utterance.listener().ifPresent(name -> arguments.add(Words.named("words", Words.name(name))));
    return new Content("say", arguments);
  }

  /**
   * The same, as a room agent has it done by another agent.
   *
   * @param caller who has told it the room agent, as {@code Caller} writes it
   */
  public static Content passedOn(Utterance utterance, String caller) {
    List<Content.Argument> arguments = new ArrayList<>(content(utterance).arguments());
    arguments.add(Words.named("caller", Words.text(caller)));
    return new Content("say", arguments);
  }

  /** The question to room agents who of them understands it. */
  public static Content asking(Utterance utterance) {
    return new Content("understand", content(utterance).arguments());
  }

  /**
   * The answer of one that does.
   *
   * @param own how many things of its own are spoken of
   */
  public static Content proposed(SpokenWords.Grasp grasp, int own) {
    return Words.content(
        "understand",
        Words.named("coverage", Words.number(grasp.coverage())),
        Words.named("own", Words.number(own)));
  }

  /** The answer of one that does not. */
  public static Content declined(SpokenWords.Grasp grasp) {
    return Words.content(
        "inform",
        Words.named("reason", Words.text(grasp.reply().orElse("That is not understood."))),
        Words.named("coverage", Words.number(grasp.coverage())));
  }

  /**
   * The answer to who asked all rooms: the agent that understands it, and what asking has taken.
   */
  public static Content understood(String agent, Duration later) {
    return Words.content("understand", named(agent, later));
  }

  private static Content.Argument[] named(String agent, Duration later) {
    return new Content.Argument[] {
      Words.named("through", Words.name(agent)),
      Words.named("later", Words.number((double) later.toMillis() / MILLIS_PER_SECOND))
    };
  }

  /**
   * An answer that another room agent has given than the one to which it was said.
   *
   * @param contents of one message, at least one
   * @param later the time that was added by that
   */
  public static List<Content> through(List<Content> contents, String agent, Duration later) {
    List<Content> all = new ArrayList<>(contents);
    List<Content.Argument> arguments = new ArrayList<>(all.get(0).arguments());
    arguments.addAll(List.of(named(agent, later)));
    all.set(0, new Content(all.get(0).operator(), arguments));
    return all;
  }

  /** The same of words after which others are to come; all that was said so far. */
  public static Content unfinished(Utterance utterance) {
    return goingOn(content(utterance));
  }

  /** The same of a request. */
  public static Content goingOn(Content said) {
    List<Content.Argument> arguments = new ArrayList<>(said.arguments());
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
    SaidReply answer = answer(contents, words);
    return words
        .string("through")
        .<SaidReply>map(agent -> new SaidReply.PassedOn(agent, words.number("later", 0), answer))
        .orElse(answer);
  }

  private static SaidReply answer(List<Content> contents, Words words) {
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

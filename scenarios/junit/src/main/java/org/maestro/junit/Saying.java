package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.agents.content.SaidReply;
import org.maestro.assembly.LocalSite;
import org.maestro.dialogue.Utterance;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * Something that was said, and what becomes of it. What does not hold of it fails the test with
 * what was answered. For the test's thread.
 */
public final class Saying {
  private final LocalSite site;
  private final String text;
  private final Duration patience;
  private final List<SaidReply> replies = new CopyOnWriteArrayList<>();

  private Saying(LocalSite site, String text, Duration patience) {
    this.site = site;
    this.text = text;
    this.patience = patience;
  }

  /** What was answered first, by whoever. */
  private SaidReply first() {
    return answer(replies.get(0));
  }

  private static SaidReply answer(SaidReply reply) {
    return reply instanceof SaidReply.PassedOn passed ? passed.answer() : reply;
  }

  static Saying begin(LocalSite site, Utterance utterance, Duration patience) {
    Saying saying = new Saying(site, utterance.text(), patience);
    site.platform().desk().say(utterance, saying.replies::add);
    if (!site.runUntil(() -> !saying.replies.isEmpty(), patience)) {
      throw new StageException("Nobody has answered \"" + utterance.text() + "\".");
    }
    return saying;
  }

  /**
   * It was understood so.
   *
   * @param message in MAESTRO-SL, such as {@code (initCNP (:goal (= (level lamp-1) 1)))}
   */
  public Saying means(String message) {
    SaidReply first = first();
    Optional<String> means =
        first instanceof SaidReply.TakenOn taken
            ? Optional.of(taken.means())
            : first instanceof SaidReply.Replied replied
                ? Optional.of(replied.means())
                : Optional.empty();
    return require(
        means.equals(Optional.of(SlPrinter.print(SlParser.content(message)))), "mean " + message);
  }

  /** It was a question, or a greeting, and this was answered. */
  public Saying replies(String sentence) {
    return require(
        first() instanceof SaidReply.Replied replied && replied.text().equals(sentence),
        "be answered: " + sentence);
  }

  /** The room did not understand it, and the agent of another one does it. */
  public Saying isPassedOnTo(String agent) {
    return require(
        replies.get(0) instanceof SaidReply.PassedOn passed && passed.agent().equals(agent),
        "be passed on to " + agent);
  }

  /** It was understood where it was said. */
  public Saying isUnderstoodHere() {
    return require(
        !(replies.get(0) instanceof SaidReply.PassedOn), "be understood where it was said");
  }

  /** This was asked back; what the person says next answers it. */
  public Saying asks(String question) {
    return require(
        first() instanceof SaidReply.Asked asked && asked.question().equals(question),
        "be asked back: " + question);
  }

  /** Nothing comes of it, for a reason in which these words stand. */
  public Saying isRefused(String reason) {
    return require(
        first() instanceof SaidReply.Refused refused && refused.why().contains(reason),
        "be refused: " + reason);
  }

  /** It was taken as the answer to the question of a script. */
  public Saying isAnAnswer() {
    return require(
        first() instanceof SaidReply.Answered, "be the answer to the question of a script");
  }

  /** Lets time pass until all that it states is so. */
  public Saying isReached() {
    awaitEnd();
    return require(end() instanceof SaidReply.Over over && over.reached(), "be reached");
  }

  /** Lets time pass until what it states has ended otherwise, for a reason with these words. */
  public Saying isNotReached(String reason) {
    awaitEnd();
    return require(
        end() instanceof SaidReply.Over over
            && !over.reached()
            && over.ends().stream()
                .flatMap(end -> end.reasons().stream())
                .anyMatch(why -> why.contains(reason)),
        "end for a reason with " + reason);
  }

  private SaidReply end() {
    return answer(replies.get(1));
  }

  private void awaitEnd() {
    require(first() instanceof SaidReply.TakenOn, "state a goal");
    if (!site.runUntil(() -> replies.size() > 1, patience)) {
      throw new StageException(
          "What \"%s\" states did not end within %s.".formatted(text, patience));
    }
  }

  private Saying require(boolean holds, String expectation) {
    if (!holds) {
      throw new AssertionError(
          "\"%s\" was to %s; what became of it: %s".formatted(text, expectation, replies));
    }
    return this;
  }
}

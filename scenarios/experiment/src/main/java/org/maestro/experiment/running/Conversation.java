package org.maestro.experiment.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.maestro.agents.content.SaidReply;
import org.maestro.assembly.LocalSite;
import org.maestro.dialogue.Utterance;

/**
 * Somebody who talks with the platform of a trial, and has no more of it than a person has: what is
 * said to her, in which voice, and how it goes with what she has said herself. For the trial's
 * thread.
 */
public final class Conversation {
  private final LocalSite site;
  private final String person;
  private final List<Heard> heard = new CopyOnWriteArrayList<>();
  private final List<Said> said = new ArrayList<>();
  private volatile String voice = "";

  private Conversation(LocalSite site, String person) {
    this.site = site;
    this.person = person;
  }

  /** From now on she hears. */
  static Conversation begin(LocalSite site, String person) {
    Conversation begun = new Conversation(site, person);
    site.platform().desk().whenShown((agent, mood) -> begun.voice = mood.word());
    site.platform()
        .desk()
        .whenSaid(
            speech -> {
              if (speech.to().equals(person)) {
                begun.heard.add(new Heard(speech.text(), begun.voice, site.clock().now()));
              }
            });
    return begun;
  }

  /**
   * A sentence that she heard.
   *
   * @param voice the mood that was shown last when it was said; "" before any was
   * @param at simulated time
   */
  public record Heard(String text, String voice, Duration at) {}

  /** Something that she has said. Its answers come while time passes. */
  public final class Said {
    private final String words;
    private final Duration at = site.clock().now();
    private final List<SaidReply> replies = new CopyOnWriteArrayList<>();

    private Said(String words) {
      this.words = words;
    }

    public String words() {
      return words;
    }

    /** When she said it; simulated time. */
    public Duration at() {
      return at;
    }

    /** Whether nothing more comes of it. */
    public boolean isOver() {
      return replies.stream().anyMatch(reply -> !(reply instanceof SaidReply.TakenOn));
    }

    /** Whether it was done. */
    public boolean isDone() {
      return replies.stream()
          .anyMatch(reply -> reply instanceof SaidReply.Over over && over.reached());
    }

    /** Why it was not done; "" when it was, or is not over. */
    public String problem() {
      return replies.stream()
          .map(Conversation::problem)
          .flatMap(Optional::stream)
          .findFirst()
          .orElse("");
    }
  }

  private static Optional<String> problem(SaidReply reply) {
    if (reply instanceof SaidReply.Refused refused) {
      return Optional.of(refused.why());
    } else if (reply instanceof SaidReply.Asked asked) {
      return Optional.of(asked.question());
    }
    return reply instanceof SaidReply.Over over && !over.reached()
        ? Optional.of(
            String.join(" ", over.ends().stream().flatMap(end -> end.reasons().stream()).toList()))
        : Optional.empty();
  }

  /** Says something; what comes of it is heard while time passes. */
  public Said say(String words) {
    Said one = new Said(words);
    said.add(one);
    site.platform()
        .desk()
        .say(new Utterance(person, "", words, Optional.empty()), one.replies::add);
    return one;
  }

  /** All that she has heard, in order. */
  public List<Heard> heard() {
    return List.copyOf(heard);
  }

  /** All that she has said, in order. */
  public List<Said> said() {
    return List.copyOf(said);
  }

  /** Lets time pass until the condition holds; says whether it does. */
  public boolean listen(BooleanSupplier until, Duration limit) {
    return site.runUntil(until, limit);
  }

  /** Simulated time. */
  public Duration now() {
    return site.clock().now();
  }
}

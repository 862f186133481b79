package org.maestro.console.questions;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import org.maestro.agents.content.Words;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.sl.Content;

/** Reads what agents answer. */
public final class Reply {
  private Reply() {}

  /**
   * The elements of a good answer.
   *
   * @throws RefusalException with the agent's own sentence when it said no
   */
  public static List<Words> lines(ACLMessage reply) {
    List<Words> words = words(reply);
    if (reply.getPerformative() == ACLMessage.FAILURE) {
      throw RefusalException.outside(reason(words));
    }
    if (reply.getPerformative() != ACLMessage.INFORM) {
      throw refusal(words);
    }
    return words;
  }

  /** What is refused for now only, since something outside fails, is no bad input. */
  public static RefusalException refusal(List<Words> words) {
    boolean temporary =
        words.stream().anyMatch(of -> of.string("temporary").filter("true"::equals).isPresent());
    boolean isOver =
        words.stream().anyMatch(of -> of.string("open").filter("false"::equals).isPresent());
    if (isOver) {
      return RefusalException.notThere(reason(words));
    }
    return temporary
        ? RefusalException.outside(reason(words))
        : RefusalException.badInput(reason(words));
  }

  public static List<Words> words(ACLMessage reply) {
    String text = reply.getContent();
    if (text == null || text.isBlank()) {
      return List.of();
    }
    List<Content> contents = Words.parse(text);
    return contents.stream().map(Words::of).toList();
  }

  public static String reason(List<Words> words) {
    return words.stream()
        .flatMap(w -> w.string("reason").or(() -> w.string("problem")).stream())
        .findFirst()
        .orElse("The platform refused without a reason.");
  }

  public static StoryEntry story(Words line) {
    return new StoryEntry(
        line.string("goal").orElse(""),
        Duration.ofMillis(Math.round(line.number("at", 0) * 1000)),
        StoryEntry.Kind.valueOf(line.string("kind").orElse("goal").toUpperCase(Locale.ROOT)),
        line.string("text").orElse(""));
  }
}

package org.maestro.agents.content;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.sl.Content;

/**
 * What is answered to words after which others are to come: {@code (inform (:looks glass-2) (:nods
 * true) (:begun G3) (:undoes G2))}. Who hears people may look and nod by it (A60, A63).
 *
 * @param looks individuals that alone can be meant
 * @param nods whether it is certain what is wanted, if nothing else follows
 * @param begun ids of goals that were begun, and go on or are reached
 * @param undone ids of goals whose effects are taken back, as the words are
 * @param refusal why nothing is begun, and will not be; empty else
 */
public record OverheardReply(
    List<String> looks,
    boolean nods,
    List<String> begun,
    List<String> undone,
    Optional<String> refusal) {
  public OverheardReply {
    looks = List.copyOf(looks);
    begun = List.copyOf(begun);
    undone = List.copyOf(undone);
  }

  /** The message's content. */
  public Content content() {
    List<Content.Argument> arguments = new ArrayList<>();
    add(arguments, "looks", looks);
    arguments.add(Words.named("nods", Words.name(Boolean.toString(nods))));
    add(arguments, "begun", begun);
    add(arguments, "undoes", undone);
    return new Content("inform", arguments);
  }

  private static void add(List<Content.Argument> arguments, String name, List<String> names) {
    if (!names.isEmpty()) {
      arguments.add(Words.named(name, names.stream().map(Words::name).toList()));
    }
  }

  /** What {@link #content} wrote, or a refusal. */
  public static OverheardReply read(String content) {
    Words words = Words.of(Words.parse(content).get(0));
    return new OverheardReply(
        words.strings("looks"),
        words.string("nods").filter("true"::equals).isPresent(),
        words.strings("begun"),
        words.strings("undoes"),
        words.string("reason").or(() -> words.string("problem")));
  }
}

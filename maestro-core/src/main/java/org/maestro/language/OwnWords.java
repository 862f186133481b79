package org.maestro.language;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.maestro.language.lexicon.Tokens;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * The speaker's own words for texts of a message: what somebody is to be told is told as it was
 * said, with its capitals and short forms. Immutable.
 */
final class OwnWords {
  /** Of longer utterances nothing is understood. */
  private static final int MOST = 120;

  private final Map<String, String> written = new HashMap<>();

  OwnWords(Tokens tokens, String utterance) {
    List<String> words = List.of(utterance.strip().split("\\s+"));
    if (words.size() <= MOST) {
      for (int from = 0; from < words.size(); from++) {
        for (int to = from + 1; to <= words.size(); to++) {
          String text =
              String.join(" ", words.subList(from, to))
                  .replaceAll("^[^\\p{L}\\p{N}]+|[.,!?;\"]+$", "");
          written.putIfAbsent(String.join(" ", tokens.of(text)), text);
        }
      }
    }
  }

  /** The message with its texts as they were said. */
  Content of(Content content) {
    return new Content(
        content.operator(), content.arguments().stream().map(this::argument).toList());
  }

  private Content.Argument argument(Content.Argument argument) {
    if (argument instanceof Content.Argument.OfTerm ofTerm
        && ofTerm.term() instanceof Term.Text text) {
      return new Content.Argument.OfTerm(
          new Term.Text(written.getOrDefault(text.value(), text.value())));
    } else if (argument instanceof Content.Argument.Named named) {
      return new Content.Argument.Named(
          named.name(), named.arguments().stream().map(this::argument).toList());
    } else if (argument instanceof Content.Argument.Nested nested) {
      return new Content.Argument.Nested(of(nested.content()));
    }
    return argument;
  }
}

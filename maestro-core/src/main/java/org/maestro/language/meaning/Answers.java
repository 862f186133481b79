package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.NounPhrases;

/**
 * What an answer, or what goes on from what was said last, means as a whole: the same act with what
 * was open, or with something else in its place (A67). Immutable.
 */
final class Answers {
  private static final List<String> AMOUNTS = List.of("number", "percent", "points", "quantity");

  private final Discourse discourse;

  Answers(Discourse discourse) {
    this.discourse = discourse;
  }

  /** The acts that may be meant, the likeliest first; none when nothing was left open. */
  Stream<Form> of(Form said) {
    Optional<Form> last = discourse.last();
    if (last.isEmpty()) {
      return Stream.empty();
    }
    return switch (said.head()) {
      case "answer" -> answered(last.get(), said.part(0));
      case "yes" ->
          said.parts().isEmpty()
              ? asked(Optional.empty(), Optional.empty()) ? last.stream() : Stream.empty()
              : Stream.empty();
      case "also" -> replaced(last.get(), said.part(0)).stream();
      default -> Stream.empty();
    };
  }

  private boolean asked(Optional<String> role, Optional<Form> phrase) {
    return discourse.asked().filter(new Discourse.Asked(role, phrase)::equals).isPresent();
  }

  private Stream<Form> answered(Form last, Form filler) {
    return discourse.asked().stream()
        .flatMap(
            asked -> {
              if (asked.role().isPresent()) {
                return filled(last, asked.role().get(), filler).stream();
              }
              return asked.phrase().stream()
                  .flatMap(phrase -> chosen(phrase, filler).map(one -> with(last, phrase, one)))
                  .filter(whole -> !whole.equals(last));
            });
  }

  /** What was asked for is this, or, where a room is said, what is in it. */
  private static Stream<Form> chosen(Form phrase, Form filler) {
    if (filler.is("all") || filler.is("both")) {
      return phrase.is("np") ? Stream.of(allOf(phrase, filler.is("both"))) : Stream.of();
    }
    if (filler.is("rel") || filler.is("here") || filler.is("there")) {
      return Stream.of(NounPhrases.placed(phrase, filler));
    }
    Stream<Form> said = Stream.of(ofKind(phrase, filler));
    return filler.is("np")
        ? Stream.concat(said, Stream.of(NounPhrases.placed(phrase, Form.of("within", filler))))
        : said;
  }

  /** All that may have been meant, or both where there are two. */
  private static Form allOf(Form phrase, boolean isOfTwo) {
    Form nominal = phrase.part(phrase.parts().size() - 1);
    return isOfTwo
        ? Form.of("np", Form.leaf("count"), Form.leaf("2"), nominal)
        : Form.of("np", Form.leaf("every"), nominal);
  }

  /** "The one on the table" is one of what was asked for. */
  private static Form ofKind(Form phrase, Form filler) {
    return head(phrase).map(head -> with(filler, Form.of("one"), head)).orElse(filler);
  }

  private static Optional<Form> head(Form phrase) {
    return phrase.is("noun") || phrase.is("name")
        ? Optional.of(phrase)
        : phrase.parts().stream().map(Answers::head).flatMap(Optional::stream).findFirst();
  }

  /** The act with the role filled. */
  private static Optional<Form> filled(Form form, String role, Form filler) {
    if (form.is("frame")) {
      List<Form> parts = new ArrayList<>(form.parts());
      parts.removeIf(part -> part.is("role") && part.text(0).equals(role));
      parts.add(Form.of("role", Form.leaf(role), filler));
      return Optional.of(new Form("frame", parts));
    }
    for (int i = 0; i < form.parts().size(); i++) {
      Optional<Form> inside = filled(form.part(i), role, filler);
      if (inside.isPresent()) {
        return Optional.of(with(form, i, inside.get()));
      }
    }
    return Optional.empty();
  }

  private static Form with(Form form, int index, Form part) {
    List<Form> parts = new ArrayList<>(form.parts());
    parts.set(index, part);
    return new Form(form.head(), parts);
  }

  /** The form with another phrase in the place of one. */
  private static Form with(Form form, Form phrase, Form other) {
    return form.equals(phrase)
        ? other
        : new Form(
            form.head(), form.parts().stream().map(part -> with(part, phrase, other)).toList());
  }

  /** The act about something else: each of its phrases may be meant, or its place. */
  private static List<Form> replaced(Form last, Form other) {
    List<Form> phrases = new ArrayList<>();
    if (isAmount(other)) {
      AMOUNTS.forEach(head -> collect(last, head, phrases));
    } else {
      collect(last, other.is("rel") ? "rel" : "np", phrases);
    }
    return phrases.stream().map(phrase -> with(last, phrase, other)).distinct().toList();
  }

  private static boolean isAmount(Form form) {
    return AMOUNTS.stream().anyMatch(form::is);
  }

  private static void collect(Form form, String head, List<Form> found) {
    if (form.is(head)) {
      found.add(form);
    }
    form.parts().forEach(part -> collect(part, head, found));
  }
}

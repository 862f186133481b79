package org.maestro.language;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.hearing.Heard;
import org.maestro.language.meaning.Doubt;
import org.maestro.language.meaning.Meaning;
import org.maestro.language.reference.Discourse;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * What an utterance was understood to be.
 *
 * @param message what is to be sent; empty when nothing is to be done
 * @param question what is asked back
 * @param reply what is said otherwise
 * @param heard each word and what became of it
 * @param meanings of all readings, the best first
 * @param began what could be begun before the end
 * @param coverage the share of words that had a place, 0 to 1
 */
public record Understanding(
    String utterance,
    Optional<Content> message,
    Optional<String> question,
    Optional<String> reply,
    List<Heard> heard,
    List<Meaning> meanings,
    List<Begun> began,
    double coverage) {

  /**
   * A reading that is under way.
   *
   * @param roles what may fill each, in order; nothing of a role that is told otherwise
   * @param said those for which something was said
   */
  public record UnderWay(String construction, Map<String, List<String>> roles, List<String> said) {
    public UnderWay {
      roles = Collections.unmodifiableMap(new LinkedHashMap<>(roles));
      said = List.copyOf(said);
    }
  }

  /**
   * What may be begun while words are still to come.
   *
   * @param after the word after which it was understood
   * @param calledOff the word after which it turned out that something else was meant
   */
  public record Begun(String after, Content message, Optional<String> calledOff) {
    Begun calledOffAfter(String word) {
      return new Begun(after, message, Optional.of(word));
    }
  }

  public Understanding {
    heard = List.copyOf(heard);
    meanings = List.copyOf(meanings);
    began = List.copyOf(began);
  }

  /** What is asked for, also where it is not done before it was confirmed. */
  public Optional<Content> wish() {
    return message.or(
        () ->
            meanings.stream()
                .findFirst()
                .filter(best -> best.doubt().filter(Doubt.Confirm.class::isInstance).isPresent())
                .flatMap(Meaning::message));
  }

  /** The same, with texts as they were said. */
  Understanding in(OwnWords own) {
    return new Understanding(
        utterance, message.map(own::of), question, reply, heard, meanings, began, coverage);
  }

  /** The words that no lexicon has. */
  public List<String> unknown() {
    return heard.stream()
        .filter(word -> word.fate() == Heard.Fate.UNKNOWN)
        .map(Heard::word)
        .toList();
  }

  /** What was spoken of, after what was spoken of before. */
  public Discourse discourse(Discourse before) {
    return meanings.stream().findFirst().map(best -> spokenOf(best, before)).orElse(before);
  }

  /** What was spoken of by a meaning, after what was spoken of before. */
  static Discourse spokenOf(Meaning said, Discourse before) {
    List<Term.Name> latest = new ArrayList<>(said.mentioned());
    List<String> kinds = new ArrayList<>(said.classes());
    Collections.reverse(latest);
    Collections.reverse(kinds);
    return before
        .with(latest, kinds, said.group())
        .saying(said.form(), said.doubt().map(Understanding::asked));
  }

  private static Discourse.Asked asked(Doubt doubt) {
    if (doubt instanceof Doubt.Missing missing) {
      return new Discourse.Asked(Optional.of(missing.role().name()), Optional.empty());
    } else if (doubt instanceof Doubt.Which which) {
      return new Discourse.Asked(Optional.empty(), Optional.of(which.said()));
    } else if (doubt instanceof Doubt.NoSuch none) {
      return new Discourse.Asked(Optional.empty(), Optional.of(none.said()));
    }
    return new Discourse.Asked(Optional.empty(), Optional.empty());
  }
}

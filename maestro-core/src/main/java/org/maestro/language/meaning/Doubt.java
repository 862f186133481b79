package org.maestro.language.meaning;

import java.util.List;
import java.util.Map;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** Why something that was said cannot be done yet. */
public sealed interface Doubt {
  /**
   * A role was not said.
   *
   * @param said what was, by the names of the other roles
   */
  record Missing(Construction construction, Construction.Role role, Map<String, Form> said)
      implements Doubt {
    public Missing {
      said = Map.copyOf(said);
    }
  }

  /** One of several may be meant. */
  record Which(Form said, List<Term.Name> candidates) implements Doubt {
    public Which {
      candidates = List.copyOf(candidates);
    }
  }

  /** There is nothing that is so. */
  record NoSuch(Form said) implements Doubt {}

  /** The number from which to reckon is not known. */
  record NotKnown(Expression.Fluent fluent) implements Doubt {}

  /** It cannot be so much, or so little: {@code least} to {@code most} it can. */
  record OutOfRange(String fluent, double least, double most) implements Doubt {}

  /** A share of nothing is nothing: it stays as it is. */
  record Unchanged(Formula so) implements Doubt {}

  /**
   * Words are unknown, and without them it can be understood.
   *
   * @param rest what was said without them
   */
  record LeftOut(List<String> words, String rest) implements Doubt {
    public LeftOut {
      words = List.copyOf(words);
    }
  }

  /** It is understood, and asked back. */
  record Confirm() implements Doubt {}

  /** It was understood, and nothing is to be done about it. */
  record Nothing(String why) implements Doubt {}
}

package org.maestro.language.reference;

import java.util.List;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** What a noun phrase refers to. */
public sealed interface Reference {

  /** One thing. */
  record Single(Term term) implements Reference {}

  /** Several things, each of them. */
  record Several(List<Term> terms) implements Reference {
    public Several {
      terms = List.copyOf(terms);
    }
  }

  /** All that are so, wherever: told by the class and what else is said of them. */
  record All(TypedVariable variable, List<Formula> conditions) implements Reference {
    public All {
      conditions = List.copyOf(conditions);
    }
  }

  /** Any that is so. */
  record Any(TypedVariable variable, List<Formula> conditions) implements Reference {
    public Any {
      conditions = List.copyOf(conditions);
    }
  }

  /** One or the other, as was said. */
  record Either(Form said, List<Reference> options) implements Reference {
    public Either {
      options = List.copyOf(options);
    }

    /** The things between which it was left, when each is one thing. */
    public Optional<List<Term.Name>> named() {
      List<Term.Name> names =
          options.stream()
              .filter(Single.class::isInstance)
              .map(option -> ((Single) option).term())
              .filter(Term.Name.class::isInstance)
              .map(Term.Name.class::cast)
              .toList();
      return names.size() == options.size() ? Optional.of(names) : Optional.empty();
    }
  }

  /** One of these was meant, and it was not said which. */
  record Open(Form said, List<Term.Name> candidates) implements Reference {
    public Open {
      candidates = List.copyOf(candidates);
    }
  }

  /** There is none that is so. */
  record None(Form said) implements Reference {}

  /** What was said is of another kind than what is wanted. */
  record Mistyped(Form said) implements Reference {}

  /** It was not said yet. */
  record Unsaid() implements Reference {}
}

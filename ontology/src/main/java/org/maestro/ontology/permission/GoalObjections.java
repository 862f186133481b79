package org.maestro.ontology.permission;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * Holds a goal against what a person may have done, before anything is done for it (ADE, 5; A85).
 * There is an objection where a part of the goal is not so yet, and all features that bring just
 * that about are kept from her. What is reached by more than one step is left to who plans: in the
 * home as it is for the person there is no plan with what she may not have done.
 */
public final class GoalObjections {
  /** So many things are tried for what a goal leaves open. */
  private static final int MOST_CHOICES = 500;

  /** So deep scripts are looked at that run others. */
  private static final int MOST_SCRIPTS = 8;

  private final Home home;
  private final Facts facts;
  private final Restrictions restrictions;
  private final Ways ways;
  private final Limits limits;

  /**
   * @param facts what is so when the goal is stated
   */
  public GoalObjections(Home home, Facts facts) {
    this.home = home;
    this.facts = facts;
    this.restrictions = Restrictions.of(home);
    this.ways = new Ways(home, facts);
    this.limits = new Limits(ways, facts);
  }

  /** How a part of a goal stands. */
  private sealed interface Standing {
    /** It is so, or may be brought about. */
    record Possible() implements Standing {}

    /** Nobody brings it about, whoever asks. */
    record Hopeless() implements Standing {}

    record Refused(Objection objection) implements Standing {}
  }

  private static final Standing POSSIBLE = new Standing.Possible();
  private static final Standing HOPELESS = new Standing.Hopeless();

  /**
   * Why it is not to be begun.
   *
   * @param goal in the home's words; it may be a script with what it takes
   * @param person who asks; empty: nobody who is known
   * @return empty when nothing is to be said against it now
   */
  public Optional<Objection> of(Formula goal, Optional<String> person) {
    if (restrictions.areNone()) {
      return Optional.empty();
    }
    return new Asked(person, true, 0).objection(goal);
  }

  /** What somebody asks for. */
  private final class Asked implements ScriptObjections.Parts {
    private final Optional<String> person;
    private final boolean now;
    private final int depth;

    /**
     * @param now whether what is so already needs nothing to be done
     * @param depth of scripts within scripts
     */
    Asked(Optional<String> person, boolean now, int depth) {
      this.person = person;
      this.now = now;
      this.depth = depth;
    }

    @Override
    public Optional<Objection> objection(Formula goal) {
      return standing(goal) instanceof Standing.Refused refused
          ? Optional.of(refused.objection())
          : Optional.empty();
    }

    @Override
    public Optional<Objection> objection(Way call) {
      return among(List.of(call), Optional.empty()) instanceof Standing.Refused refused
          ? Optional.of(refused.objection())
          : Optional.empty();
    }

    @Override
    public Optional<Objection> objection(Script script, List<Term> arguments) {
      return depth >= MOST_SCRIPTS
          ? Optional.empty()
          : new ScriptObjections(home, new Asked(person, now, depth + 1)).of(script, arguments);
    }

    Standing standing(Formula goal) {
      if (goal instanceof Formula.Bound bound) {
        return new Asked(person, false, depth).standing(bound.goal());
      } else if (goal instanceof Formula.Keep keep) {
        return new Asked(person, false, depth).standing(keep.body());
      } else if (goal instanceof Formula.And and) {
        return all(and.operands().stream().map(this::standing).toList());
      } else if (goal instanceof Formula.Or or) {
        return any(or.operands().stream().map(this::standing));
      } else if (goal instanceof Formula.Exists exists) {
        return choices(exists.variables())
            .map(some -> any(some.map(one -> standing(one.apply(exists.body())))))
            .orElse(POSSIBLE);
      } else if (goal instanceof Formula.Forall forall) {
        return choices(forall.variables())
            .map(some -> all(some.map(one -> standing(one.apply(forall.body()))).toList()))
            .orElse(POSSIBLE);
      } else if (goal instanceof Formula.Not not && not.operand() instanceof Formula.Atom atom) {
        return isSo(goal) ? POSSIBLE : atom(atom, false);
      } else if (goal instanceof Formula.Atom atom) {
        return isSo(goal) ? POSSIBLE : atom(atom, true);
      } else if (goal instanceof Formula.Comparison comparison) {
        return isSo(goal) ? POSSIBLE : comparison(comparison);
      }
      return POSSIBLE;
    }

    private boolean isSo(Formula goal) {
      return now
          && FreeVariables.of(goal).isEmpty()
          && new Evaluation(facts).truth(goal, Map.of()) == Truth.TRUE;
    }

    private Standing atom(Formula.Atom atom, boolean holding) {
      Script script = home.scripts().get(atom.predicate());
      if (script != null) {
        return run(script, atom.arguments());
      }
      List<Way> all = ways.of(atom, holding);
      Standing byScripts =
          holding
              ? any(ways.byScripts(atom).stream().map(one -> run(one.script(), one.arguments())))
              : HOPELESS;
      return any(Stream.of(among(all, Optional.empty(), isOpen(atom.predicate())), byScripts));
    }

    private Standing run(Script script, List<Term> arguments) {
      return objection(script, arguments).<Standing>map(Standing.Refused::new).orElse(POSSIBLE);
    }

    private Standing comparison(Formula.Comparison comparison) {
      if (comparison.left() instanceof Expression.Fluent fluent
          && comparison.right() instanceof Expression.OfTerm of
          && of.term() instanceof Term.Number number) {
        return among(
            ways.of(fluent),
            Optional.of(new Limits.Wanted(fluent, comparison.relation(), number.value())),
            isOpen(fluent.name()));
      }
      return POSSIBLE;
    }

    /** Whether it may come about by what changes something else. */
    private boolean isOpen(String word) {
      return ways.isDerived(word) || home.vocabulary().classes().containsKey(word);
    }

    private Standing among(List<Way> all, Optional<Limits.Wanted> wanted, boolean isOpen) {
      return all.isEmpty() && isOpen ? POSSIBLE : among(all, wanted);
    }

    private Standing among(List<Way> all, Optional<Limits.Wanted> wanted) {
      if (all.isEmpty()) {
        return HOPELESS;
      }
      return all.stream().anyMatch(way -> may(person, way, wanted))
          ? POSSIBLE
          : new Standing.Refused(refusal(all.get(0), wanted));
    }

    private Objection refusal(Way way, Optional<Limits.Wanted> wanted) {
      return new Objection(
          person,
          way,
          limits.missed(restrictions.condition(person, way.device(), way.feature()), way, wanted),
          restrictions.persons().stream()
              .filter(other -> may(Optional.of(other), way, wanted))
              .toList(),
          restrictions.names(person, way.device(), way.feature()));
    }
  }

  private boolean may(Optional<String> person, Way way, Optional<Limits.Wanted> wanted) {
    return limits.mayHold(restrictions.condition(person, way.device(), way.feature()), way, wanted);
  }

  /** A part that nobody brings about leaves the whole to who explains that. */
  private static Standing all(List<Standing> parts) {
    return parts.contains(HOPELESS)
        ? HOPELESS
        : parts.stream().filter(Standing.Refused.class::isInstance).findFirst().orElse(POSSIBLE);
  }

  private static Standing any(Stream<Standing> parts) {
    Standing best = HOPELESS;
    for (Standing part : (Iterable<Standing>) parts::iterator) {
      if (part.equals(POSSIBLE)) {
        return part;
      }
      best = best.equals(HOPELESS) ? part : best;
    }
    return best;
  }

  /** What the variables may stand for; empty where that is too much to be tried. */
  private Optional<Stream<Substitution>> choices(List<TypedVariable> variables) {
    List<Substitution> choices = new ArrayList<>(List.of(new Substitution(Map.of())));
    for (TypedVariable variable : variables) {
      List<Substitution> longer = new ArrayList<>();
      for (Substitution before : choices) {
        for (Term.Name one : facts.individuals(variable.className().orElse(""))) {
          Map<String, Term> terms = new HashMap<>(before.terms());
          terms.put(variable.name(), one);
          longer.add(new Substitution(terms));
        }
        if (longer.size() > MOST_CHOICES) {
          return Optional.empty();
        }
      }
      choices = longer;
    }
    return Optional.of(choices.stream());
  }
}

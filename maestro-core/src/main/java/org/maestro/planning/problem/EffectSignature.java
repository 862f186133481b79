package org.maestro.planning.problem;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.maestro.sl.Effect;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * One thing that a feature brings about, by which it can stand in for another: to make something
 * so, to change a number, to find something out. What is so no more by the way counts only when a
 * feature does nothing else.
 *
 * @param subject a predicate or a fluent
 * @param own which of its arguments are the executing member itself: to hold a thing is another
 *     deed than to be somewhere
 */
public record EffectSignature(Kind kind, String subject, List<Integer> own) {
  enum Kind {
    MAKES_SO,
    CHANGES,
    FINDS_OUT,
    ENDS
  }

  public static Set<EffectSignature> of(Effect effect) {
    Set<EffectSignature> deeds = new LinkedHashSet<>();
    collect(effect, deeds);
    if (deeds.stream().anyMatch(deed -> deed.kind() != Kind.ENDS)) {
      deeds.removeIf(deed -> deed.kind() == Kind.ENDS);
    }
    return deeds;
  }

  private static void collect(Effect effect, Set<EffectSignature> deeds) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, deeds));
    } else if (effect instanceof Effect.When when) {
      collect(when.effect(), deeds);
    } else if (effect instanceof Effect.Forall forall) {
      collect(forall.effect(), deeds);
    } else if (effect instanceof Effect.Add add) {
      deeds.add(of(Kind.MAKES_SO, add.atom().predicate(), add.atom().arguments()));
    } else if (effect instanceof Effect.Delete delete) {
      deeds.add(of(Kind.ENDS, delete.atom().predicate(), delete.atom().arguments()));
    } else if (effect instanceof Effect.Change change) {
      deeds.add(of(Kind.CHANGES, change.fluent().name(), change.fluent().arguments()));
    } else if (effect instanceof Effect.SenseAtom sense) {
      deeds.add(of(Kind.FINDS_OUT, sense.atom().predicate(), sense.atom().arguments()));
    } else if (effect instanceof Effect.SenseNumber sense) {
      deeds.add(of(Kind.FINDS_OUT, sense.fluent().name(), sense.fluent().arguments()));
    }
  }

  private static EffectSignature of(Kind kind, String subject, List<Term> arguments) {
    return new EffectSignature(
        kind,
        subject,
        IntStream.range(0, arguments.size())
            .filter(n -> arguments.get(n) instanceof Term.Variable v && v.name().equals(Self.NAME))
            .boxed()
            .toList());
  }
}

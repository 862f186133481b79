package org.maestro.knowledge.calibration;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Share;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Expression;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * The numbers of which a home's words say that others have shares in them. What is stated of a
 * share is looked up once, before anything is learnt of it. Confined to one thread.
 */
final class SharedNumbers {
  private final List<PredicateDeclaration> shares;
  private final Map<Expression.Fluent, Double> stated = new LinkedHashMap<>();

  SharedNumbers(Vocabulary vocabulary) {
    this.shares =
        vocabulary.predicates().values().stream()
            .filter(declared -> declared.shareOf().isPresent())
            .toList();
  }

  boolean isEmpty() {
    return shares.isEmpty();
  }

  boolean has(Expression.Fluent number) {
    return shares.stream().anyMatch(one -> share(one).in(number).isPresent());
  }

  /** Whether the formula speaks of such numbers. */
  boolean areIn(String formula) {
    return shares.stream()
        .anyMatch(one -> formula.contains("(" + share(one).number().name() + " "));
  }

  /** All that has a share in the number, by what is stated. */
  List<Part> parts(Expression.Fluent number, Snapshot now) {
    List<Part> parts = new ArrayList<>();
    for (PredicateDeclaration declared : shares) {
      share(declared).in(number).ifPresent(bindings -> addParts(declared, bindings, now, parts));
    }
    return parts;
  }

  private void addParts(
      PredicateDeclaration declared, Map<String, Term> bindings, Snapshot now, List<Part> parts) {
    Share share = share(declared);
    for (Map<String, Term> all : bound(share.open(declared.parameters()), bindings, now)) {
      Substitution ground = new Substitution(all);
      Expression.Fluent fluent = fluent(declared, ground);
      double number = stated(fluent, now);
      if (number != 0) {
        parts.add(new Part(fluent, ground.apply(share.setting()), number));
      }
    }
  }

  /**
   * The same share wherever else it has one: of a lamp what it gives to other locations.
   *
   * @param part of a number that is measured
   */
  List<Part> elsewhere(Part part, Snapshot now) {
    List<Part> others = new ArrayList<>();
    shares.stream()
        .filter(declared -> declared.name().equals(part.share().name()))
        .forEach(declared -> addElsewhere(declared, part, now, others));
    return others;
  }

  private void addElsewhere(
      PredicateDeclaration declared, Part part, Snapshot now, List<Part> others) {
    Share share = share(declared);
    Set<TypedVariable> open = share.open(declared.parameters());
    Map<String, Term> kept = new LinkedHashMap<>();
    List<TypedVariable> free = new ArrayList<>();
    for (int n = 0; n < declared.parameters().size(); n++) {
      TypedVariable parameter = declared.parameters().get(n);
      if (open.contains(parameter)) {
        kept.put(parameter.name(), part.share().arguments().get(n));
      } else {
        free.add(parameter);
      }
    }
    for (Map<String, Term> all : bound(Set.copyOf(free), kept, now)) {
      Expression.Fluent fluent = fluent(declared, new Substitution(all));
      double number = fluent.equals(part.share()) ? 0 : stated(fluent, now);
      if (number != 0) {
        others.add(new Part(fluent, part.setting(), number));
      }
    }
  }

  /** The number in which the fluent's is a share. */
  Expression.Fluent number(Expression.Fluent share) {
    PredicateDeclaration declared =
        shares.stream().filter(one -> one.name().equals(share.name())).findFirst().orElseThrow();
    Map<String, Term> bindings = new LinkedHashMap<>();
    for (int n = 0; n < declared.parameters().size(); n++) {
      bindings.put(declared.parameters().get(n).name(), share.arguments().get(n));
    }
    return new Substitution(bindings).apply(share(declared).number());
  }

  /** With one more argument, each individual of its class; with more there are too many. */
  private static List<Map<String, Term>> bound(
      Set<TypedVariable> open, Map<String, Term> bindings, Snapshot now) {
    if (open.isEmpty()) {
      return List.of(bindings);
    } else if (open.size() > 1) {
      return List.of();
    }
    TypedVariable one = open.iterator().next();
    return one.className().stream()
        .flatMap(name -> now.individuals(name).stream())
        .map(
            individual -> {
              Map<String, Term> all = new LinkedHashMap<>(bindings);
              all.put(one.name(), individual);
              return all;
            })
        .toList();
  }

  private static Expression.Fluent fluent(PredicateDeclaration declared, Substitution ground) {
    List<Term> variables =
        declared.parameters().stream().<Term>map(p -> new Term.Variable(p.name())).toList();
    return ground.apply(new Expression.Fluent(declared.name(), variables));
  }

  private double stated(Expression.Fluent share, Snapshot now) {
    Double known = stated.get(share);
    if (known == null) {
      OptionalDouble number = now.number(share);
      known = number.orElse(0);
      stated.put(share, known);
    }
    return known;
  }

  private static Share share(PredicateDeclaration declared) {
    return declared.shareOf().orElseThrow();
  }
}

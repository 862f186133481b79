package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What can be done with devices, in the words by which it is asked for: of what their features
 * bring about, as far as there are words for it. Immutable.
 */
public final class AbilityWords {
  private static final int MOST_VERBS = 5;
  private static final int MOST_GROUPS = 8;

  private final Home home;
  private final Grammar grammar;
  private final Naming naming;
  private final Phrases phrases;
  private final Situation situation;

  public AbilityWords(Situation situation, Grammar grammar) {
    this.home = situation.home();
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
    this.phrases = new Phrases(grammar);
    this.situation = situation;
  }

  /**
   * A sentence that tells it.
   *
   * @param present the devices that are there, by their names
   * @param place in which; empty: of all, by their kinds
   */
  public String of(Collection<String> present, Optional<Term> place) {
    Map<List<String>, Set<String>> things = new LinkedHashMap<>();
    Set<String> services = new LinkedHashSet<>();
    for (String name : present) {
      Device device = home.devices().get(name);
      if (device == null || place.isPresent() && !isIn(new Term.Name(name), place.get())) {
        continue;
      }
      List<String> verbs = verbs(device);
      if (verbs.isEmpty()) {
        services.addAll(services(device));
      } else {
        things
            .computeIfAbsent(verbs, key -> new LinkedHashSet<>())
            .add(place.isPresent() ? naming.word(name) : kinds(name));
      }
    }
    List<String> told =
        Stream.concat(
                things.entrySet().stream()
                    .limit(MOST_GROUPS)
                    .map(entry -> told(entry.getKey(), List.copyOf(entry.getValue()))),
                services.stream().limit(MOST_VERBS))
            .toList();
    return told.isEmpty()
        ? phrases.of("able-nothing")
        : phrases.of("able", Map.of("deeds", String.join("; ", told)));
  }

  /** What it does with other things, whichever they are. */
  private List<String> services(Device device) {
    List<String> services = new ArrayList<>();
    for (Construction construction : home.wording().constructions()) {
      boolean isOfOthers =
          construction.roles().stream()
              .allMatch(role -> home.vocabulary().classes().containsKey(role.type()));
      if (isOfOthers
          && role(construction, device).isEmpty()
          && DeedWords.goal(construction)
              .filter(goal -> isBroughtAbout(goal, construction, device, Set.of(Self.NAME)))
              .isPresent()) {
        Map<String, String> any =
            construction.roles().stream()
                .collect(
                    Collectors.toMap(
                        Construction.Role::name, role -> phrases.any(naming.bare(role.type()))));
        construction.says().stream()
            .filter(said -> said.isIn(grammar.language()))
            .map(Said::text)
            .filter(said -> DeedWords.isSayable(said, any.keySet(), grammar))
            .findFirst()
            .ifPresent(said -> services.add(Phrases.filled(said, any)));
      }
    }
    return services;
  }

  private String told(List<String> verbs, List<String> things) {
    return Phrases.filled(phrases.listed(verbs), Map.of("it", phrases.listed(things)))
        .replaceFirst("\\s+$", "");
  }

  /** The plural of its kind. */
  private String kinds(String name) {
    return naming
        .kind(new Term.Name(name))
        .map(kind -> grammar.inflection().of(kind, "plural"))
        .orElseGet(() -> naming.word(name));
  }

  private boolean isIn(Term thing, Term place) {
    Evaluation evaluation = new Evaluation(situation.facts());
    for (PredicateDeclaration predicate : new Relations(situation).ofPlaces()) {
      Formula.Atom atom = new Formula.Atom(predicate.name(), List.of(thing, place));
      if (evaluation.truth(atom, Map.of()) == Truth.TRUE) {
        return true;
      }
    }
    return false;
  }

  /** Patterns in which the device is {it}, which stands behind the last verb only. */
  private List<String> verbs(Device device) {
    List<String> patterns = new ArrayList<>();
    for (Construction construction : home.wording().constructions()) {
      if (DeedWords.goal(construction)
          .filter(goal -> isBroughtAbout(goal, construction, device, Set.of()))
          .isPresent()) {
        role(construction, device)
            .flatMap(role -> said(construction, role))
            .ifPresent(patterns::add);
      }
    }
    List<String> verbs =
        patterns.stream().distinct().limit(MOST_VERBS).collect(Collectors.toList());
    for (int i = 0; i < verbs.size() - 1; i++) {
      verbs.set(i, verbs.get(i).replace(" {it}", ""));
    }
    return verbs;
  }

  /** Whether its features bring that about, and it speaks of nothing but the roles. */
  private static boolean isBroughtAbout(
      Formula goal, Construction construction, Device device, Set<String> others) {
    boolean[] all = {true};
    Leaves.of(
        goal,
        atom -> all[0] &= changes(device, atom.predicate()),
        fluent -> all[0] &= changes(device, fluent.name()));
    Set<String> variables = new LinkedHashSet<>(FreeVariables.of(goal));
    variables.removeAll(others);
    construction.roles().forEach(role -> variables.remove(role.name()));
    return all[0] && variables.isEmpty() && !(goal instanceof Formula.Exists);
  }

  private static boolean changes(Device device, String predicate) {
    return device.features().stream()
        .anyMatch(feature -> SlPrinter.print(feature.effect()).contains("(" + predicate + " "));
  }

  private static Optional<Construction.Role> role(Construction construction, Device device) {
    return construction.roles().stream()
        .filter(role -> device.individual().classes().contains(role.type()))
        .findFirst();
  }

  /** The first pattern that ends with this role, and has no other. */
  private Optional<String> said(Construction construction, Construction.Role role) {
    String place = "{" + role.name() + "}";
    return construction.says().stream()
        .filter(said -> said.isIn(grammar.language()))
        .map(Said::text)
        .filter(said -> said.endsWith(" " + place) && said.indexOf('{') == said.lastIndexOf('{'))
        .filter(said -> !DeedWords.isOptional(said))
        .map(said -> said.replace(place, "{it}"))
        .findFirst();
  }
}

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
  private static final String IT = "{it}";

  private final Home home;
  private final Grammar grammar;
  private final Naming naming;
  private final Phrases phrases;
  private final Situation situation;
  private final Verbs verbs;

  public AbilityWords(Situation situation, Grammar grammar) {
    this.home = situation.home();
    this.grammar = grammar;
    this.naming = new Naming(home, grammar);
    this.phrases = new Phrases(grammar);
    this.situation = situation;
    this.verbs = new Verbs(grammar);
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
      List<String> deeds = deeds(device);
      if (deeds.isEmpty()) {
        services.addAll(services(device));
      } else {
        things
            .computeIfAbsent(deeds, key -> new LinkedHashSet<>())
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
          && ConstructedGoals.stated(construction)
              .filter(goal -> isBroughtAbout(goal, construction, device, Set.of(Self.NAME)))
              .isPresent()) {
        Map<String, String> any =
            construction.roles().stream()
                .collect(
                    Collectors.toMap(
                        Construction.Role::name, role -> any(naming.word(role.type()))));
        construction.says().stream()
            .filter(said -> said.isIn(grammar.language()))
            .map(Said::text)
            .filter(said -> verbs.isSayable(said, any.keySet()))
            .findFirst()
            .ifPresent(said -> services.add(phrases.filled(verbs.joined(said), any)));
      }
    }
    return services;
  }

  /** Any thing of a kind, whichever it is. */
  private String any(String kind) {
    return phrases.of("able-any", Map.of("any", phrases.any(kind), "plural", naming.plural(kind)));
  }

  private String object(String thing) {
    return phrases.of("object", Map.of("thing", thing));
  }

  private String told(List<String> deeds, List<String> things) {
    return phrases
        .filled(phrases.listed(deeds), Map.of("it", object(phrases.listed(things))))
        .replaceFirst("\\s+$", "");
  }

  /** The plural of its kind. */
  private String kinds(String name) {
    return naming.kind(new Term.Name(name)).map(naming::plural).orElseGet(() -> naming.word(name));
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

  /** Patterns in which the device is {it}, which is said once, next to the outermost verb. */
  private List<String> deeds(Device device) {
    List<String> patterns = new ArrayList<>();
    for (Construction construction : home.wording().constructions()) {
      if (ConstructedGoals.stated(construction)
          .filter(goal -> isBroughtAbout(goal, construction, device, Set.of()))
          .isPresent()) {
        role(construction, device)
            .flatMap(role -> said(construction, role))
            .ifPresent(patterns::add);
      }
    }
    List<String> all = patterns.stream().distinct().limit(MOST_VERBS).collect(Collectors.toList());
    int outermost = verbs.areLast() ? 0 : all.size() - 1;
    for (int i = 0; i < all.size(); i++) {
      all.set(i, i == outermost ? all.get(i) : all.get(i).replace(IT, "").strip());
    }
    return all;
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

  /** The first pattern in which this role stands at the other end than the verb, and no other. */
  private Optional<String> said(Construction construction, Construction.Role role) {
    String place = "{" + role.name() + "}";
    return construction.says().stream()
        .filter(said -> said.isIn(grammar.language()))
        .map(Said::text)
        .filter(said -> verbs.areLast() ? said.startsWith(place + " ") : said.endsWith(" " + place))
        .filter(said -> said.indexOf('{') == said.lastIndexOf('{') && !Verbs.isOptional(said))
        .map(said -> verbs.joined(said).replace(place, IT))
        .findFirst();
  }
}

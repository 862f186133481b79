package org.maestro.language.wording;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * What is done for a goal, as people say it: by the home's constructions, read from what they mean
 * to their words. Immutable.
 */
public final class DeedWords {
  private static final String ING = "ing";
  private static final String SPAN = "duration";

  private final Home home;
  private final Grammar grammar;
  private final Phrases phrases;
  private final SpanWords spans;
  private final NamedTerms terms;
  private final FactWords facts;
  private final OccasionWords occasions;
  private final Verbs verbs;
  private final ConstructedGoals constructed;

  /**
   * In a language.
   *
   * @param listener the person who is spoken to, by her name in the home
   */
  public DeedWords(Home home, Grammar grammar, Optional<String> listener) {
    this.home = home;
    this.grammar = grammar;
    this.phrases = new Phrases(grammar);
    this.spans = new SpanWords(grammar);
    this.terms = new NamedTerms(home, grammar, listener);
    this.facts = new FactWords(home, grammar, listener);
    this.occasions = new OccasionWords(grammar, facts);
    this.verbs = new Verbs(grammar);
    this.constructed = new ConstructedGoals(home);
  }

  /**
   * A pattern and what stands in its places.
   *
   * @param pattern begins with the verb in its base form, or ends with it
   * @param unusual how many words are more usual for it
   * @param telling whether it has a word of the state that comes about
   */
  private record Deed(String pattern, Map<String, String> roles, int unusual, boolean telling) {
    Deed(String pattern, Map<String, String> roles) {
      this(pattern, roles, 0, false);
    }

    Deed {
      roles = Map.copyOf(roles);
    }
  }

  private String text(Deed deed) {
    return phrases.filled(deed.pattern(), deed.roles());
  }

  /** Such as turn on the kitchen light; empty when there are no words for it. */
  public Optional<String> of(Formula goal) {
    return deeds(goal).map(deeds -> phrases.listed(deeds.stream().map(this::text).toList()));
  }

  /** Such as turning on the kitchen light. */
  public Optional<String> doing(Formula goal) {
    return deeds(goal)
        .map(deeds -> phrases.listed(deeds.stream().map(deed -> doing(text(deed))).toList()));
  }

  private String doing(String deed) {
    int blank = deed.indexOf(' ');
    String verb = blank < 0 ? deed : deed.substring(0, blank);
    return grammar.inflection().of(verb, ING) + deed.substring(verb.length());
  }

  private Optional<List<Deed>> deeds(Formula goal) {
    Set<String> open = FreeVariables.of(goal);
    if (goal instanceof Formula.Bound bound) {
      return deeds(bound.goal()).flatMap(deeds -> bound(deeds, bound));
    } else if (!open.isEmpty()) {
      return deeds(
          new Formula.Exists(
              open.stream().map(name -> new TypedVariable(name, Optional.empty())).toList(), goal));
    }
    Optional<Deed> whole = constructed(goal, terms);
    if (whole.isPresent()) {
      return whole.map(List::of);
    } else if (goal instanceof Formula.Keep) {
      return facts.of(goal).map(fact -> List.of(seeingToIt("deed-keep", fact)));
    } else if (goal instanceof Formula.And and) {
      return all(and);
    }
    return facts.of(goal).map(fact -> List.of(seeingToIt("deed-so", fact)));
  }

  private Deed seeingToIt(String phrase, String fact) {
    return new Deed(phrases.of(phrase), Map.of("fact", fact));
  }

  private Optional<List<Deed>> bound(List<Deed> deeds, Formula.Bound bound) {
    boolean isUntil = bound instanceof Formula.Until;
    return occasions
        .of(bound.occasion(), isUntil)
        .map(
            when ->
                deeds.stream()
                    .map(deed -> new Deed(deed.pattern() + " " + when, deed.roles()))
                    .toList());
  }

  /** What is done with several in the same words is told once. */
  private Optional<List<Deed>> all(Formula.And and) {
    List<Deed> all = new ArrayList<>();
    for (Formula part : and.operands()) {
      Optional<List<Deed>> deeds = deeds(part);
      if (deeds.isEmpty()) {
        return Optional.empty();
      }
      all.addAll(deeds.get());
    }
    Map<String, List<Deed>> alike = new LinkedHashMap<>();
    all.forEach(deed -> alike.computeIfAbsent(deed.pattern(), key -> new ArrayList<>()).add(deed));
    return Optional.of(alike.values().stream().flatMap(same -> together(same).stream()).toList());
  }

  private List<Deed> together(List<Deed> alike) {
    Deed first = alike.get(0);
    List<String> different =
        first.roles().keySet().stream()
            .filter(role -> alike.stream().map(d -> d.roles().get(role)).distinct().count() > 1)
            .toList();
    if (different.size() > 1) {
      return alike;
    }
    Map<String, String> roles = new HashMap<>(first.roles());
    different.forEach(
        role ->
            roles.put(role, phrases.listed(alike.stream().map(d -> d.roles().get(role)).toList())));
    return List.of(new Deed(first.pattern(), roles));
  }

  private Optional<Deed> constructed(Formula goal, NamedTerms named) {
    if (goal instanceof Formula.Exists exists
        && exists.body() instanceof Formula.Atom
        && exists.variables().size() == 1) {
      Optional<Deed> looking = best(goal, named);
      return looking.isPresent()
          ? looking
          : best(exists.body(), named.within(exists.variables(), exists.body(), false));
    }
    return best(goal, named);
  }

  /** Words of the state that comes about make a pattern fit best, then fewer words. */
  private Optional<Deed> best(Formula goal, NamedTerms named) {
    Set<String> states = stateWords(goal);
    return home.wording().constructions().stream()
        .flatMap(one -> deeds(one, goal, named, states))
        .min(
            Comparator.comparing((Deed deed) -> !deed.telling())
                .thenComparing(Deed::unusual)
                .thenComparing(deed -> deed.pattern().split(" ").length));
  }

  private boolean tells(String word, Set<String> states) {
    return states.contains(word) || states.contains(grammar.inflection().of(word, "done"));
  }

  /** The usual words for what comes about. */
  private Set<String> stateWords(Formula goal) {
    return home.wording().states().stream()
        .filter(state -> state.broughtAboutBy().flatMap(by -> Matching.of(by, goal)).isPresent())
        .flatMap(
            state -> state.says().stream().filter(one -> one.isIn(grammar.language())).limit(1))
        .map(Said::text)
        .collect(Collectors.toSet());
  }

  /** In all words that the construction has for it. */
  private Stream<Deed> deeds(
      Construction construction, Formula goal, NamedTerms named, Set<String> states) {
    Optional<Formula> pattern = constructed.goal(construction);
    Optional<Map<String, Term>> bound = pattern.flatMap(one -> Matching.of(one, goal));
    boolean isOfAnother =
        bound.map(values -> values.get(Self.NAME)).filter(self -> !isDevice(self)).isPresent();
    if (bound.isEmpty() || isOfAnother) {
      return Stream.empty();
    }
    Map<String, String> roles = new HashMap<>();
    for (Construction.Role role : construction.roles()) {
      Term term = bound.get().get(role.name());
      Optional<String> text = term == null ? Optional.empty() : text(role, term, named);
      if (term != null && text.isEmpty()) {
        return Stream.empty();
      }
      text.ifPresent(one -> roles.put(role.name(), phrases.of("object", Map.of("thing", one))));
    }
    List<String> said =
        construction.says().stream()
            .filter(one -> one.isIn(grammar.language()))
            .map(Said::text)
            .toList();
    return said.stream()
        .filter(one -> verbs.isSayable(one, roles.keySet()))
        .map(
            one ->
                new Deed(
                    verbs.joined(one),
                    roles,
                    said.indexOf(one),
                    Verbs.words(one).anyMatch(word -> tells(word, states))));
  }

  private boolean isDevice(Term term) {
    return term instanceof Term.Name name && home.devices().containsKey(name.text());
  }

  private Optional<String> text(Construction.Role role, Term term, NamedTerms named) {
    if (term instanceof Term.Number number) {
      return role.type().equals(SPAN)
          ? Optional.of(spans.of(Duration.ofMillis((long) (number.value() * 1000))))
          : named.text(term);
    }
    return term instanceof Term.Text text
        ? Optional.of(text.value())
        : named.isA(term, role.type()) ? named.text(term) : Optional.empty();
  }
}

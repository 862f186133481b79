package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Predicates of two arguments, as prepositions name them. What was found out is remembered. Not
 * safe for threads.
 */
public final class Relations {
  /** The geometry function by which it is known in which room something is. */
  private static final String INSIDE = "inside";

  /** The properties by which a home says where something is. */
  private static final List<String> POSITIONS = List.of("pose", "position");

  /** So many tell whether others like them stand somewhere. */
  private static final int FEW = 4;

  private final Home home;
  private final Vocabulary vocabulary;
  private final Facts facts;
  private final Evaluation evaluation;
  private final List<PredicateDeclaration> pairs;
  private final List<PredicateDeclaration> ofPlaces;

  /** The classes of what may be in places, or is one. */
  private final List<String> placeable;

  /** Whether of some predicate whatever stands somewhere may be in a place. */
  private final boolean anythingMayBePlaced;

  private final Map<Term, Owner> belonging = new HashMap<>();
  private final Map<Formula.Atom, Boolean> held = new HashMap<>();

  public Relations(Situation situation) {
    this.home = situation.home();
    this.vocabulary = home.vocabulary();
    this.facts = situation.facts();
    this.evaluation = new Evaluation(facts);
    this.pairs =
        vocabulary.predicates().values().stream()
            .filter(predicate -> predicate.parameters().size() == 2)
            .toList();
    this.ofPlaces = List.copyOf(withWordsOf(INSIDE));
    this.anythingMayBePlaced =
        ofPlaces.stream().anyMatch(predicate -> typeOf(predicate, 0).isEmpty());
    this.placeable =
        ofPlaces.stream()
            .map(one -> typeOf(one, 0).isEmpty() ? typeOf(one, 1) : typeOf(one, 0))
            .distinct()
            .toList();
  }

  /** The predicates that a preposition may be, in the order of its form. */
  List<PredicateDeclaration> named(Form preposition) {
    return preposition.parts().stream()
        .map(part -> vocabulary.predicate(part.head()))
        .flatMap(Optional::stream)
        .filter(predicate -> predicate.parameters().size() == 2)
        .toList();
  }

  /** The predicates by which it is said in what something is: those with a word of "inside". */
  public List<PredicateDeclaration> ofPlaces() {
    return ofPlaces;
  }

  private List<PredicateDeclaration> withWordsOf(String relation) {
    Set<String> words = new LinkedHashSet<>();
    prepositions(relation).forEach(said -> words.add(said.text()));
    List<PredicateDeclaration> found = new ArrayList<>();
    for (Map.Entry<String, List<Said>> entry : home.wording().prepositions().entrySet()) {
      if (entry.getValue().stream().anyMatch(said -> words.contains(said.text()))) {
        vocabulary
            .predicate(entry.getKey())
            .filter(predicate -> predicate.parameters().size() == 2)
            .ifPresent(
                // What is called so first of all is meant first.
                one -> found.add(isFirst(entry.getValue(), words) ? 0 : found.size(), one));
      }
    }
    return found;
  }

  private static boolean isFirst(List<Said> said, Set<String> words) {
    return words.contains(said.get(0).text());
  }

  private List<Said> prepositions(String predicate) {
    return home.wording().prepositions().getOrDefault(predicate, List.of());
  }

  /** Whether what is of the class may stand at that place of the predicate. */
  public boolean fits(PredicateDeclaration predicate, int place, String className) {
    return predicate
        .parameters()
        .get(place)
        .className()
        .map(wanted -> className.isEmpty() || vocabulary.mayBeBoth(className, wanted))
        .orElse(true);
  }

  /** Whether the thing may stand there. */
  public boolean fits(PredicateDeclaration predicate, int place, Term term) {
    return predicate
        .parameters()
        .get(place)
        .className()
        .map(wanted -> isA(term, wanted))
        .orElse(true);
  }

  /** Whether an individual is of the class; of "" everything is. */
  public boolean isA(Term term, String className) {
    if (className.isEmpty()) {
      return true;
    }
    Individual individual =
        term instanceof Term.Name name ? home.individuals().get(name.text()) : null;
    return individual != null && individual.classes().contains(className);
  }

  /** Whether somebody can bring it about, rather than that it follows from others. */
  public static boolean isBroughtAbout(PredicateDeclaration predicate) {
    return predicate.computedBy().isEmpty()
        && predicate.derivedWhen().isEmpty()
        && predicate.countedWhen().isEmpty();
  }

  /** What of the class is known to be in what the thing is in, or in the thing itself. */
  public List<Term.Name> within(Term thing, String className) {
    Set<Term.Name> found = new HashSet<>();
    for (PredicateDeclaration predicate : ofPlaces) {
      if (fits(predicate, 0, thing)) {
        fewer(className, typeOf(predicate, 1)).stream()
            .filter(place -> fits(predicate, 1, place) && isA(place, className))
            .filter(place -> holds(predicate.name(), thing, place))
            .forEach(found::add);
      }
      if (fits(predicate, 1, thing)) {
        fewer(className, typeOf(predicate, 0)).stream()
            .filter(other -> isPlaceable(other) && isA(other, className))
            .filter(other -> fits(predicate, 0, other) && holds(predicate.name(), other, thing))
            .forEach(found::add);
      }
    }
    return found.isEmpty()
        ? List.of()
        : facts.individuals(className).stream().filter(found::contains).toList();
  }

  /** The individuals of that of two classes of which there are fewer. */
  private Collection<Term.Name> fewer(String one, String other) {
    Collection<Term.Name> ones = facts.individuals(one);
    Collection<Term.Name> others = facts.individuals(other);
    return ones.size() <= others.size() ? ones : others;
  }

  /** Whether it may be in a place at all, rather than being no thing, as titles are. */
  boolean isPlaceable(Term.Name name) {
    Individual individual = home.individuals().get(name.text());
    if (individual == null) {
      return false;
    }
    for (String type : placeable) {
      if (type.isEmpty() || individual.classes().contains(type)) {
        return true;
      }
    }
    return anythingMayBePlaced && stands(individual);
  }

  /** Whether what is of the class may be in a place at all; of no class anything may. */
  public boolean mayBeSomewhere(String className) {
    return !vocabulary.classes().containsKey(className)
        || ofPlaces.stream()
            .anyMatch(
                predicate ->
                    typeOf(predicate, 0).isEmpty()
                        ? facts.individuals(className).stream()
                            .limit(FEW)
                            .anyMatch(this::isPlaceable)
                        : fits(predicate, 0, className));
  }

  /** Whether the home says where it is. */
  private static boolean stands(Individual individual) {
    Map<String, List<Term>> properties = individual.properties();
    if (properties.isEmpty()) {
      return false;
    }
    for (String position : POSITIONS) {
      if (properties.containsKey(position)) {
        return true;
      }
    }
    return false;
  }

  /** Whether it is known that the thing is in the place, by whichever predicate says so. */
  boolean isIn(Term thing, Term place) {
    return ofPlaces().stream()
        .filter(predicate -> fits(predicate, 0, thing) && fits(predicate, 1, place))
        .anyMatch(predicate -> holds(predicate.name(), thing, place));
  }

  /**
   * Whether nobody knows that the thing is elsewhere than where the place is: then whoever says
   * that it is there may know.
   */
  boolean mayBeAt(Term thing, Term place) {
    List<Truth> truths =
        home.wording().prepositions().keySet().stream()
            .map(vocabulary::predicate)
            .flatMap(Optional::stream)
            .filter(predicate -> predicate.parameters().size() == 2 && isBroughtAbout(predicate))
            .filter(predicate -> fits(predicate, 0, thing) && fits(predicate, 1, place))
            .map(predicate -> new Formula.Atom(predicate.name(), List.of(thing, place)))
            .map(atom -> evaluation.truth(atom, Map.of()))
            .toList();
    return truths.stream().anyMatch(truth -> truth != Truth.FALSE);
  }

  /** Whether the formula holds, or tells where something is and is not known to be false. */
  boolean mayHold(Formula formula, Map<String, Term> bindings) {
    if (!bindings.keySet().containsAll(FreeVariables.of(formula))) {
      return false;
    }
    Truth truth = evaluation.truth(formula, bindings);
    return truth == Truth.TRUE || truth == Truth.UNKNOWN && isOfPlaces(formula);
  }

  /** Whether it tells where something is, or what else prepositions tell. */
  private boolean isOfPlaces(Formula formula) {
    if (formula instanceof Formula.Or or) {
      return or.operands().stream().allMatch(this::isOfPlaces);
    }
    return formula instanceof Formula.Atom atom
        && home.wording().prepositions().containsKey(atom.predicate())
        && vocabulary.predicate(atom.predicate()).filter(Relations::isBroughtAbout).isPresent();
  }

  /** Whether one has the other, by whichever predicate relates both, or by its name. */
  boolean belongs(Term thing, Term owner) {
    return belonging.computeIfAbsent(owner, Owner::new).has(thing);
  }

  /** Of whom things may be, and by which predicates. */
  private final class Owner {
    private final Term owner;
    private final List<PredicateDeclaration> having;
    private final List<PredicateDeclaration> had;

    Owner(Term owner) {
      this.owner = owner;
      Set<String> prepositions = home.wording().prepositions().keySet();
      this.having =
          pairs.stream()
              .filter(pair -> prepositions.contains(pair.name()) || isOwn(pair))
              .filter(pair -> fits(pair, 1, owner))
              .toList();
      this.had = pairs.stream().filter(pair -> isOwn(pair) && fits(pair, 0, owner)).toList();
    }

    boolean has(Term thing) {
      return having.stream()
              .anyMatch(pair -> fits(pair, 0, thing) && holds(pair.name(), thing, owner))
          || had.stream()
              .anyMatch(pair -> fits(pair, 1, thing) && holds(pair.name(), owner, thing));
    }

    private boolean isOwn(PredicateDeclaration pair) {
      return !pair.fluent() && pair.computedBy().isEmpty();
    }
  }

  /**
   * With what a device has to do now, at least among several things: what it plays, sees or stands
   * beside.
   *
   * @param className of which all of these are; "" for any
   */
  Set<Term.Name> concernedBy(Term device, Collection<Term.Name> among, String className) {
    return ofDevices(device)
        .filter(predicate -> fits(predicate, 1, className))
        .flatMap(
            predicate ->
                told(predicate, device)
                    .map(Set::stream)
                    .orElseGet(() -> fitting(predicate, among))
                    .filter(other -> holds(predicate.name(), device, other)))
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /** What is of no class, such as the state that a member tells, is a text and no thing. */
  private Stream<Term.Name> fitting(PredicateDeclaration predicate, Collection<Term.Name> among) {
    return typeOf(predicate, 1).isEmpty()
        ? Stream.empty()
        : among.stream().filter(other -> fits(predicate, 1, other));
  }

  /** Things that something's own state names, rather than what is observed of it. */
  Set<Term.Name> namedBy(Term thing) {
    return ofDevices(thing)
        .filter(predicate -> !predicate.observable())
        .flatMap(
            predicate ->
                told(predicate, thing)
                    .map(Set::stream)
                    .orElseGet(() -> facts.individuals(typeOf(predicate, 1)).stream())
                    .filter(other -> holds(predicate.name(), thing, other)))
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  private Stream<PredicateDeclaration> ofDevices(Term device) {
    return pairs.stream()
        .filter(predicate -> !predicate.fluent())
        .filter(predicate -> predicate.computedBy().isEmpty() && fits(predicate, 0, device));
  }

  /** Those with which it may hold, where the facts tell that without trying each. */
  private Optional<Set<Term.Name>> told(PredicateDeclaration predicate, Term thing) {
    return facts
        .candidates(new Formula.Atom(predicate.name(), List.of(thing, new Term.Variable("y"))), "y")
        .map(
            terms ->
                terms.stream()
                    .filter(Term.Name.class::isInstance)
                    .map(Term.Name.class::cast)
                    .collect(Collectors.toCollection(LinkedHashSet::new)));
  }

  private boolean holds(String predicate, Term thing, Term other) {
    return held.computeIfAbsent(
        new Formula.Atom(predicate, List.of(thing, other)),
        atom -> evaluation.truth(atom, Map.of()) == Truth.TRUE);
  }

  /** Whether the formula is known to hold. */
  public boolean holds(Formula formula, Map<String, Term> bindings) {
    return bindings.keySet().containsAll(FreeVariables.of(formula))
        && evaluation.truth(formula, bindings) == Truth.TRUE;
  }

  /** The class of the predicate's argument; "" for any. */
  public static String typeOf(PredicateDeclaration predicate, int place) {
    return predicate.parameters().get(place).className().orElse("");
  }
}

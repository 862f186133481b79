package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
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

/** Predicates of two arguments, as prepositions name them. Immutable. */
public final class Relations {
  /** The geometry function by which it is known in which room something is. */
  private static final String INSIDE = "inside";

  private final Home home;
  private final Vocabulary vocabulary;
  private final Facts facts;

  public Relations(Situation situation) {
    this.home = situation.home();
    this.vocabulary = home.vocabulary();
    this.facts = situation.facts();
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
    Set<String> words = new LinkedHashSet<>();
    prepositions(INSIDE).forEach(said -> words.add(said.text()));
    List<PredicateDeclaration> found = new ArrayList<>();
    for (Map.Entry<String, List<Said>> entry : home.wording().prepositions().entrySet()) {
      if (entry.getValue().stream().anyMatch(said -> words.contains(said.text()))) {
        vocabulary
            .predicate(entry.getKey())
            .filter(predicate -> predicate.parameters().size() == 2)
            .ifPresent(found::add);
      }
    }
    return found;
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
            .map(predicate -> truth(new Formula.Atom(predicate.name(), List.of(thing, place))))
            .toList();
    return truths.stream().anyMatch(truth -> truth != Truth.FALSE);
  }

  private Truth truth(Formula formula) {
    return new Evaluation(facts).truth(formula, Map.of());
  }

  /** Whether the formula holds, or tells where something is and is not known to be false. */
  boolean mayHold(Formula formula, Map<String, Term> bindings) {
    return holds(formula, bindings)
        || isOfPlaces(formula)
            && bindings.keySet().containsAll(FreeVariables.of(formula))
            && new Evaluation(facts).truth(formula, bindings) != Truth.FALSE;
  }

  private boolean isOfPlaces(Formula formula) {
    if (formula instanceof Formula.Or or) {
      return or.operands().stream().allMatch(this::isOfPlaces);
    }
    return formula instanceof Formula.Atom atom
        && home.wording().prepositions().containsKey(atom.predicate())
        && vocabulary.predicate(atom.predicate()).filter(Relations::isBroughtAbout).isPresent();
  }

  /** Whether any preposition's predicate is known to hold of both. */
  boolean areRelated(Term thing, Term other) {
    return home.wording().prepositions().keySet().stream()
        .map(vocabulary::predicate)
        .flatMap(Optional::stream)
        .filter(predicate -> predicate.parameters().size() == 2)
        .filter(predicate -> fits(predicate, 0, thing) && fits(predicate, 1, other))
        .anyMatch(predicate -> holds(predicate.name(), thing, other));
  }

  /** Whether one has the other, by whichever predicate relates both, or by its name. */
  boolean belongs(Term thing, Term owner) {
    return areRelated(thing, owner)
        || vocabulary.predicates().values().stream()
            .filter(predicate -> !predicate.fluent() && predicate.parameters().size() == 2)
            .filter(predicate -> predicate.computedBy().isEmpty())
            .anyMatch(
                predicate ->
                    fits(predicate, 0, thing)
                            && fits(predicate, 1, owner)
                            && holds(predicate.name(), thing, owner)
                        || fits(predicate, 0, owner)
                            && fits(predicate, 1, thing)
                            && holds(predicate.name(), owner, thing));
  }

  /** Things that a device's own state names. */
  List<Term.Name> concernedBy(Term device) {
    return vocabulary.predicates().values().stream()
        .filter(predicate -> !predicate.fluent() && predicate.parameters().size() == 2)
        .filter(predicate -> predicate.computedBy().isEmpty() && fits(predicate, 0, device))
        .flatMap(
            predicate ->
                facts
                    .candidates(
                        new Formula.Atom(predicate.name(), List.of(device, new Term.Variable("y"))),
                        "y")
                    .orElseGet(() -> Set.copyOf(facts.individuals(typeOf(predicate, 1))))
                    .stream()
                    .filter(Term.Name.class::isInstance)
                    .map(Term.Name.class::cast)
                    .filter(other -> holds(predicate.name(), device, other)))
        .distinct()
        .toList();
  }

  private boolean holds(String predicate, Term thing, Term other) {
    return holds(new Formula.Atom(predicate, List.of(thing, other)), Map.of());
  }

  /** Whether the formula is known to hold. */
  public boolean holds(Formula formula, Map<String, Term> bindings) {
    return bindings.keySet().containsAll(FreeVariables.of(formula))
        && new Evaluation(facts).truth(formula, bindings) == Truth.TRUE;
  }

  /** The class of the predicate's argument; "" for any. */
  public static String typeOf(PredicateDeclaration predicate, int place) {
    return predicate.parameters().get(place).className().orElse("");
  }
}

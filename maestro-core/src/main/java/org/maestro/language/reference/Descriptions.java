package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.language.grammar.Form;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.StateWord;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** Reads what nominals say of things. Bound to one situation. */
final class Descriptions {
  private final Situation situation;
  private final Relations relations;
  private final NounPhrases phrases;

  Descriptions(Situation situation, Relations relations, NounPhrases phrases) {
    this.situation = situation;
    this.relations = relations;
    this.phrases = phrases;
  }

  /**
   * What the nominal says.
   *
   * @return empty when something in it refers to nothing, or to nobody knows what
   */
  Optional<Description> of(Form nominal) {
    return switch (nominal.head()) {
      case "noun" -> Optional.of(Description.ofClass(nominal.text(0)));
      case "name" -> Optional.of(Description.ofNames(nominal));
      case "called" -> of(nominal.part(1)).map(head -> called(head, nominal.part(0).text(0)));
      case "any" -> Optional.of(Description.ofClass(""));
      case "one" -> latestKind().map(Description::ofClass);
      case "mod" -> of(nominal.part(1)).map(head -> head.with(adjective(nominal.part(0))));
      case "instate" -> of(nominal.part(1)).flatMap(head -> inState(head, nominal.part(0)));
      case "at" -> of(nominal.part(0)).flatMap(head -> placed(head, nominal.part(1)));
      case "beside", "of" -> of(nominal.part(1)).flatMap(head -> owned(head, nominal.part(0)));
      case "nth" ->
          of(nominal.part(1))
              .map(head -> head.choosing(new Choice.Nth(NounPhrases.wholeNumber(nominal.text(0)))));
      case "extreme" -> of(nominal.part(1)).map(head -> head.choosing(extreme(nominal.part(0))));
      case "either" -> oneOf(nominal.parts());
      case "around" -> of(nominal.part(1)).flatMap(head -> around(head, nominal.part(0)));
      case "other" -> of(nominal.part(0)).map(this::other);
      case "_" -> Optional.of(Description.ofClass(""));
      default -> Optional.empty();
    };
  }

  /** The kind that was spoken of last, in this sentence or before it. */
  private Optional<String> latestKind() {
    List<String> now = phrases.kinds();
    return now.isEmpty()
        ? situation.discourse().classes().stream().findFirst()
        : Optional.of(now.get(now.size() - 1));
  }

  /** Of those that are called so the ones that are of the class. */
  private Description called(Description named, String className) {
    return named.with(candidate -> relations.isA(candidate, className));
  }

  private Description other(Description head) {
    return situation.discourse().things().stream()
        .filter(thing -> relations.isA(thing, head.className()))
        .findFirst()
        .or(() -> phrases.present(head.className()))
        .map(
            last ->
                head.with(
                    new Formula.Not(
                        new Formula.Comparison(
                            Formula.Relation.EQUAL,
                            new Expression.OfTerm(Description.VARIABLE),
                            new Expression.OfTerm(last)))))
        .orElse(head);
  }

  private static Formula adjective(Form adjective) {
    Term value =
        adjective.text(2).equals("name")
            ? new Term.Name(adjective.text(1))
            : new Term.Text(adjective.text(1));
    return new Formula.Atom(adjective.text(0), List.of(Description.VARIABLE, value));
  }

  private static Choice extreme(Form measures) {
    return new Choice.Extreme(
        measures.parts().stream().map(Form::head).toList(), measures.is("more"));
  }

  /** Whichever of these things, of the narrowest kind that all of them are of. */
  private Optional<Description> oneOf(List<Form> options) {
    List<Term> things = new ArrayList<>();
    for (Form option : options) {
      if (!(phrases.resolve(option, "") instanceof Reference.Single single)) {
        return Optional.empty();
      }
      things.add(single.term());
    }
    Formula one =
        new Formula.Or(
            things.stream()
                .<Formula>map(
                    thing ->
                        new Formula.Comparison(
                            Formula.Relation.EQUAL,
                            new Expression.OfTerm(Description.VARIABLE),
                            new Expression.OfTerm(thing)))
                .toList());
    return situation.home().vocabulary().classes().values().stream()
        .filter(kind -> things.stream().allMatch(thing -> relations.isA(thing, kind.name())))
        .max(Comparator.comparingInt(kind -> kind.ancestors().size()))
        .map(kind -> Description.ofClass(kind.name()).with(one));
  }

  /** The place in which something is. */
  private Optional<Description> around(Description head, Form phrase) {
    return phrases.resolve(phrase, "") instanceof Reference.Single single
        ? Optional.of(head.with(candidate -> relations.isIn(single.term(), candidate)))
        : Optional.empty();
  }

  private Optional<Description> inState(Description head, Form state) {
    if (state.is("not")) {
      return inStates(head, state.part(0)).map(holds -> head.with(new Formula.Not(holds)));
    }
    if (state.is("and")) {
      return inState(head, state.part(0)).flatMap(both -> inState(both, state.part(1)));
    }
    return inStates(head, state).map(head::with);
  }

  private Optional<Formula> inStates(Description head, Form state) {
    List<Formula> holding = new ArrayList<>();
    for (StateWord word : situation.home().wording().states()) {
      if (state.parts().contains(Form.leaf(word.name())) && mayBe(head, word.of())) {
        holding.add(new Substitution(Map.of("it", Description.VARIABLE)).apply(word.holdsWhen()));
      }
    }
    return holding.isEmpty()
        ? Optional.empty()
        : Optional.of(holding.size() == 1 ? holding.get(0) : new Formula.Or(holding));
  }

  private boolean mayBe(Description head, String className) {
    return head.named().isEmpty()
        ? head.className().isEmpty()
            || situation.home().vocabulary().mayBeBoth(head.className(), className)
        : head.named().stream().anyMatch(name -> relations.isA(name, className));
  }

  private Optional<Description> placed(Description head, Form where) {
    switch (where.head()) {
      case "here":
        return situation.here().map(here -> within(head, new Term.Name(here)).placedSomewhere());
      case "there":
        return phrases.lastPlace().map(place -> within(head, place).placedSomewhere());
      case "everywhere":
        return Optional.of(head.anywhere());
      case "either", "each":
        return either(head, where);
      case "where":
        return whereIs(head, where.part(0));
      case "within":
        return phrases.resolve(where.part(0), "") instanceof Reference.Single place
            ? Optional.of(within(head, place.term()).placedSomewhere())
            : Optional.empty();
      case "from":
        return from(head, where.part(0));
      case "rel":
        return related(head, where.part(0), where.part(1));
      default:
        return Optional.of(head);
    }
  }

  /** In the same place as something else. */
  private Optional<Description> whereIs(Description head, Form phrase) {
    if (!(phrases.resolve(phrase, "") instanceof Reference.Single single)) {
      return Optional.empty();
    }
    List<Term> places =
        relations.ofPlaces().stream()
            .map(predicate -> Relations.typeOf(predicate, 1))
            .distinct()
            .flatMap(type -> situation.facts().individuals(type).stream())
            .filter(place -> relations.isIn(single.term(), place))
            .<Term>map(place -> place)
            .distinct()
            .toList();
    return places.size() == 1
        ? Optional.of(within(head, places.get(0)).placedSomewhere())
        : Optional.empty();
  }

  private Optional<Description> either(Description head, Form where) {
    Optional<Description> one = placed(head, where.part(0));
    Optional<Description> other = placed(head, where.part(1));
    if (one.isEmpty() || other.isEmpty()) {
      return Optional.empty();
    }
    Description first = one.get();
    Description second = other.get();
    List<Formula> here = more(first, head);
    List<Formula> there = more(second, head);
    // What a formula says can be asked for, too.
    boolean isOfFormulas = !here.isEmpty() && !there.isEmpty();
    Description placed =
        isOfFormulas
            ? head.with(new Formula.Or(List.of(all(here), all(there))))
            : head.with(
                candidate -> phrases.isSo(first, candidate) || phrases.isSo(second, candidate));
    return Optional.of(placed.placedSomewhere());
  }

  private static Formula all(List<Formula> conditions) {
    return conditions.size() == 1 ? conditions.get(0) : new Formula.And(conditions);
  }

  /** The conditions that came to the head's; none where something came that is no formula. */
  private static List<Formula> more(Description placed, Description head) {
    return placed.tests().equals(head.tests()) && placed.className().equals(head.className())
        ? placed.conditions().stream().filter(one -> !head.conditions().contains(one)).toList()
        : List.of();
  }

  private Description within(Description head, Term place) {
    List<PredicateDeclaration> fitting =
        bestOf(
            relations.ofPlaces().stream()
                .filter(predicate -> relations.fits(predicate, 1, place))
                .filter(
                    predicate ->
                        !head.className().isEmpty()
                            && relations.fits(predicate, 0, head.className()))
                .toList());
    return fitting.isEmpty()
        ? head.with(candidate -> relations.isIn(candidate, place))
        : head.with(new Formula.Atom(fitting.get(0).name(), List.of(Description.VARIABLE, place)));
  }

  private Optional<Description> related(Description head, Form preposition, Form phrase) {
    List<PredicateDeclaration> fitting =
        bestOf(
            relations.named(preposition).stream()
                .filter(
                    predicate ->
                        head.named().isEmpty()
                            ? relations.fits(predicate, 0, head.className())
                                && (!Relations.typeOf(predicate, 0).isEmpty()
                                    || relations.mayBeSomewhere(head.className()))
                            : head.named().stream()
                                .anyMatch(name -> relations.fits(predicate, 0, name)))
                .toList());
    if (phrase.is("_")) {
      return Optional.of(
          head.with(
              candidate ->
                  fitting.stream()
                      .anyMatch(predicate -> phrases.isRelatedToAnything(predicate, candidate))));
    }
    List<Formula> either = new ArrayList<>();
    for (PredicateDeclaration predicate : fitting) {
      either.addAll(to(predicate, phrases.resolve(phrase, Relations.typeOf(predicate, 1))));
    }
    if (either.isEmpty()) {
      return Optional.empty();
    }
    Formula condition = either.size() == 1 ? either.get(0) : new Formula.Or(either);
    return Optional.of(head.with(condition).placedSomewhere());
  }

  /** Each way in which it may be related to what is referred to. */
  private static List<Formula> to(PredicateDeclaration predicate, Reference other) {
    if (other instanceof Reference.Single single) {
      return List.of(to(predicate, single.term()));
    } else if (other instanceof Reference.Any any) {
      return List.of(some(predicate, any));
    } else if (other instanceof Reference.Several several) {
      return several.terms().stream().map(term -> to(predicate, term)).toList();
    } else if (other instanceof Reference.Open open) {
      return open.candidates().stream().map(term -> to(predicate, term)).toList();
    } else if (other instanceof Reference.Either options) {
      return options.options().stream().flatMap(one -> to(predicate, one).stream()).toList();
    }
    return List.of();
  }

  private static Formula to(PredicateDeclaration predicate, Term other) {
    return new Formula.Atom(predicate.name(), List.of(Description.VARIABLE, other));
  }

  /** What can be brought about is told by what is computed, too, and is meant. */
  private static List<PredicateDeclaration> bestOf(List<PredicateDeclaration> predicates) {
    List<PredicateDeclaration> best =
        predicates.stream().filter(Relations::isBroughtAbout).toList();
    return best.isEmpty() ? predicates : best;
  }

  private static Formula some(PredicateDeclaration predicate, Reference.Any any) {
    List<Formula> parts = new ArrayList<>(any.conditions());
    parts.add(
        new Formula.Atom(
            predicate.name(),
            List.of(Description.VARIABLE, new Term.Variable(any.variable().name()))));
    return new Formula.Exists(
        List.of(any.variable()), parts.size() == 1 ? parts.get(0) : new Formula.And(parts));
  }

  /** What is there, or of which nobody knows where it is, and the speaker says where. */
  private Optional<Description> from(Description head, Form where) {
    Optional<Description> known = owned(head, where);
    boolean isAnyKnown =
        known.filter(there -> !phrases.candidates(there, head.className()).isEmpty()).isPresent();
    return isAnyKnown || !(phrases.resolve(where, "") instanceof Reference.Single place)
        ? known
        : Optional.of(
            head.with(candidate -> relations.mayBeAt(candidate, place.term())).supposing());
  }

  private Optional<Description> owned(Description head, Form owner) {
    Form phrase =
        owner.is("name") || owner.is("noun") ? Form.of("np", Form.leaf("the"), owner) : owner;
    Reference whose = phrases.resolve(phrase, "");
    if (whose instanceof Reference.Open open) {
      return Optional.of(
          head.with(
                  candidate ->
                      open.candidates().stream().anyMatch(one -> relations.belongs(candidate, one)))
              .placedSomewhere());
    }
    if (!(whose instanceof Reference.Single single)) {
      return Optional.empty();
    }
    boolean isHere =
        relations.ofPlaces().stream().anyMatch(p -> relations.fits(p, 1, single.term()));
    Optional<Formula> inside =
        relations.ofPlaces().stream()
            .filter(Relations::isBroughtAbout)
            .filter(
                p -> relations.fits(p, 1, single.term()) && relations.fits(p, 0, head.className()))
            .findFirst()
            .map(p -> new Formula.Atom(p.name(), List.of(Description.VARIABLE, single.term())));
    Description owned =
        inside.isPresent()
            ? head.with(inside.get())
            : head.with(candidate -> relations.belongs(candidate, single.term()));
    boolean isNobodys =
        owner.is("speaker") && phrases.candidates(owned, head.className()).isEmpty();
    return Optional.of(isNobodys ? head : isHere ? owned.placedSomewhere() : owned);
  }
}

package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.language.grammar.Form;
import org.maestro.language.reference.NounPhrases;
import org.maestro.language.reference.Reference;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.wording.Measure;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** Numbers that are set, raised, lowered and asked for. Bound to one reading. */
final class Measures {
  private static final double HUNDRED = 100;
  private static final String CELSIUS = "DEG_C";
  private static final String KELVIN = "K";
  private static final String PERCENT = "PERCENT";
  private static final double MORE_THAN_BEFORE = 1.5;
  private static final double ROUNDED = 1e9;

  private final Situation situation;
  private final Set<String> idle;
  private final Vocabulary vocabulary;
  private final NounPhrases phrases;
  private final References references;
  private final Settables settables;

  Measures(Situation situation, References references, Set<String> idle) {
    this.situation = situation;
    this.idle = idle;
    this.vocabulary = situation.home().vocabulary();
    this.references = references;
    this.settables = new Settables(situation.home());
    this.phrases = references.phrases();
  }

  /** A number, and of what it is. */
  record Of(PredicateDeclaration fluent, Reference whose) {}

  /** {@code (assign measure amount)}: the goal that it be so much. */
  Optional<Formula> assigned(Form measure, Form amount) {
    return of(measure, amount, true)
        .flatMap(
            of ->
                references.over(
                    of.whose(),
                    term ->
                        value(of, amount)
                            .filter(value -> isInRange(of, value))
                            .map(value -> equal(of.fluent(), term, value))));
  }

  /** The measure of what is there; the same, where it was said of what it is. */
  static Form placed(Form measure, Form where) {
    if (measure.parts().isEmpty()) {
      return Form.of(measure.head(), where);
    }
    if (measure.is("alike")) {
      return Form.of("alike", placed(measure.part(0), where), measure.part(1));
    }
    int last = measure.parts().size() - 1;
    Form whose = measure.part(last);
    Form placed = NounPhrases.placed(whose, where);
    if (!placed.equals(whose)) {
      List<Form> parts = new ArrayList<>(measure.parts());
      parts.set(last, placed);
      return new Form(measure.head(), parts);
    }
    return whose.is("fluent") || whose.is("more") || whose.is("less")
        ? Form.of("measure", whose, where)
        : measure;
  }

  private boolean isInRange(Of of, double value) {
    boolean isInRange = mayBe(of, value);
    if (!isInRange) {
      references.doubt(
          new Doubt.OutOfRange(
              of.fluent().name(), least(of), measure(of).whole().orElse(Double.MAX_VALUE)));
    }
    return isInRange;
  }

  /** The goal that it be more, or less, by so much or by a step. */
  Optional<Formula> changed(Form measure, Form by, int sign) {
    return of(measure, by, true)
        .flatMap(
            of ->
                references.over(
                    of.whose(),
                    term -> {
                      OptionalDouble now = now(of, term);
                      if (now.isEmpty()) {
                        return Optional.empty();
                      }
                      double step = step(of, by, now);
                      Formula changed =
                          equal(of.fluent(), term, within(of, now.getAsDouble() + sign * step));
                      if (step == 0 && of.whose() instanceof Reference.Single) {
                        references.doubt(new Doubt.Unchanged(changed));
                        return Optional.empty();
                      }
                      return Optional.of(changed);
                    }));
  }

  /** The goal that there be half as much again, or half of it. */
  Optional<Formula> more(Form measure, int sign) {
    return of(measure, Form.HOLE, false)
        .flatMap(
            of ->
                references.over(
                    of.whose(),
                    term -> {
                      OptionalDouble now = now(of, term);
                      if (now.isEmpty()) {
                        return Optional.empty();
                      }
                      double factor = sign > 0 ? MORE_THAN_BEFORE : 1 / MORE_THAN_BEFORE;
                      return Optional.of(
                          new Formula.Comparison(
                              sign > 0 ? Formula.Relation.AT_LEAST : Formula.Relation.AT_MOST,
                              fluent(of.fluent(), term),
                              number(rounded(now.getAsDouble() * factor))));
                    }));
  }

  /** A comparison with an amount, of what is measured first. */
  Optional<Formula> compared(Form measure, Formula.Relation relation, Form amount) {
    return of(measure, amount, false).flatMap(of -> compared(of, relation, amount));
  }

  /** The same as a wish: first of what can be set, as the target of a temperature. */
  Optional<Formula> bounded(Form measure, Formula.Relation relation, Form amount) {
    return found(measure, amount, true)
        .filter(of -> !(of.whose() instanceof Reference.None))
        .or(() -> of(measure, amount, false))
        .flatMap(of -> compared(of, relation, amount));
  }

  private Optional<Formula> compared(Of of, Formula.Relation relation, Form amount) {
    return references.over(
        of.whose(),
        term ->
            value(of, amount)
                .map(
                    value ->
                        new Formula.Comparison(
                            relation, fluent(of.fluent(), term), number(value))));
  }

  /** A comparison of the same number of two things. */
  Optional<Formula> comparedWith(Form measure, Formula.Relation relation, Form other) {
    return of(measure, Form.HOLE, false)
        .flatMap(
            of ->
                references.over(
                    of.whose(),
                    term ->
                        references.over(
                            whoseElse(of.fluent(), other),
                            than ->
                                Optional.of(
                                    new Formula.Comparison(
                                        relation,
                                        fluent(of.fluent(), term),
                                        fluent(of.fluent(), than))))));
  }

  private Reference whoseElse(PredicateDeclaration fluent, Form whose) {
    Reference itself = whose(fluent, whose, false);
    return itself instanceof Reference.Mistyped ? whose(fluent, whose, true) : itself;
  }

  /** The fluents that are asked for, of each thing one. */
  List<Expression.Fluent> asked(Form measure) {
    return of(measure, Form.HOLE, false).stream()
        .flatMap(
            of -> {
              if (of.whose() instanceof Reference.Single single) {
                return Stream.of(fluent(of.fluent(), single.term()));
              } else if (of.whose() instanceof Reference.Several several) {
                return several.terms().stream().map(term -> fluent(of.fluent(), term));
              }
              references.over(of.whose(), term -> Optional.empty());
              return Stream.of();
            })
        .toList();
  }

  private static Expression.Fluent fluent(PredicateDeclaration fluent, Term term) {
    return new Expression.Fluent(fluent.name(), List.of(term));
  }

  private static Expression number(double value) {
    return new Expression.OfTerm(new Term.Number(value));
  }

  private static Formula equal(PredicateDeclaration fluent, Term term, double value) {
    return new Formula.Comparison(Formula.Relation.EQUAL, fluent(fluent, term), number(value));
  }

  private OptionalDouble now(Of of, Term term) {
    Expression.Fluent fluent = fluent(of.fluent(), term);
    OptionalDouble now =
        term.isGround() ? situation.facts().number(fluent) : OptionalDouble.empty();
    if (now.isEmpty()) {
      references.doubt(new Doubt.NotKnown(fluent));
    }
    return now;
  }

  private Measure measure(Of of) {
    return measure(of.fluent());
  }

  private Measure measure(PredicateDeclaration fluent) {
    return Optional.ofNullable(situation.home().wording().measures().get(fluent.name()))
        .orElseGet(
            () ->
                new Measure(
                    fluent.name(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    List.of(),
                    List.of(),
                    List.of(),
                    false));
  }

  /** Empty where such an amount says nothing of the number. */
  private Optional<Double> value(Of of, Form amount) {
    OptionalDouble whole = measure(of).whole();
    return switch (amount.head()) {
      case "number" -> Optional.of(scaled(of, numeric(amount)));
      case "percent", "share" ->
          mayBeInPercent(of.fluent()) ? Optional.of(share(of, amount)) : Optional.empty();
      case "points" -> Optional.of(scaled(of, numeric(amount)));
      case "quantity" -> Optional.of(rounded(Values.inCelsius(amount)));
      case "most" -> whole.isPresent() ? Optional.of(whole.getAsDouble()) : Optional.empty();
      case "least" -> Optional.of(of.fluent().least().orElse(0));
      case "as" -> as(of, amount.part(0));
      default -> Optional.empty();
    };
  }

  /** So many hundredths of the whole. */
  private double share(Of of, Form amount) {
    return rounded(numeric(amount) * measure(of).whole().orElse(HUNDRED) / HUNDRED);
  }

  /** As much as something else has now. */
  private Optional<Double> as(Of of, Form other) {
    Reference than = whoseElse(of.fluent(), other);
    if (than instanceof Reference.Single single) {
      OptionalDouble now = now(of, single.term());
      return now.isPresent() ? Optional.of(now.getAsDouble()) : Optional.empty();
    }
    references.over(than, term -> Optional.empty());
    return Optional.empty();
  }

  /** A lamp at fifty is half on: above the whole, a number is a percentage. */
  private double scaled(Of of, double number) {
    OptionalDouble whole = measure(of).whole();
    return whole.isPresent() && whole.getAsDouble() <= 1 && number > whole.getAsDouble()
        ? rounded(number * whole.getAsDouble() / HUNDRED)
        : number;
  }

  private double step(Of of, Form by, OptionalDouble now) {
    Measure measure = measure(of);
    double step = measure.step().orElse(measure.whole().orElse(10) / 10);
    return switch (by.head()) {
      case "percent" -> now.orElse(0) * numeric(by) / HUNDRED;
      case "number", "points" -> scaled(of, numeric(by));
      case "share" -> share(of, by);
      case "quantity" -> by.text(1).equals(Values.FAHRENHEIT) ? numeric(by) / 1.8 : numeric(by);
      case "much" -> 2 * step;
      default -> step;
    };
  }

  private double within(Of of, double value) {
    double most = measure(of).whole().orElse(Double.MAX_VALUE);
    return rounded(Math.max(least(of), Math.min(most, value)));
  }

  /** What is a part of a whole is no less than nothing. */
  private double least(Of of) {
    return of.fluent().least().orElse(measure(of).whole().isPresent() ? 0 : -Double.MAX_VALUE);
  }

  private static double rounded(double value) {
    return Math.abs(value) < ROUNDED ? Math.round(value * ROUNDED) / ROUNDED : value;
  }

  private static double numeric(Form amount) {
    return Double.parseDouble(amount.text(0));
  }

  /**
   * Which number is spoken of, and of what: first of what was said or is here itself, then of what
   * is there.
   *
   * @param set whether it is to be set, rather than asked for
   */
  private Optional<Of> of(Form measure, Form amount, boolean set) {
    Form said = measure.part(0);
    if (said.is("it") && phrases.resolve(said, "") instanceof Reference.None none) {
      references.doubt(new Doubt.NoSuch(none.said()));
      return Optional.empty();
    }
    Optional<Of> found = found(measure, amount, set);
    if (found.isEmpty()) {
      references.die();
    }
    return found;
  }

  private Optional<Of> found(Form said, Form amount, boolean set) {
    Form measure = said.is("alike") ? alike(said.part(0), said.part(1)) : said;
    Form named = measure.part(0);
    boolean isNamed =
        named.is("fluent") || named.is("more") || named.is("less") || named.is("howMuch");
    Form whose = isNamed ? measure.part(1) : named;
    List<PredicateDeclaration> fluents =
        set
            ? fluents(isNamed ? named : Form.HOLE, amount)
            : measuredFirst(fluents(isNamed ? named : Form.HOLE, amount));
    Optional<Of> broken = Optional.empty();
    List<Of> thereabouts = new ArrayList<>();
    for (boolean around : new boolean[] {false, true}) {
      for (PredicateDeclaration fluent : fluents) {
        if (set && around && !mayStandForItsPlace(fluent, whose)) {
          continue;
        }
        Reference found = whose(fluent, whose, around);
        Reference reference = set ? settables.of(fluent, found) : found;
        if (reference instanceof Reference.Mistyped
            || reference instanceof Reference.Unsaid
            || set && !settables.maySet(fluent, reference)) {
          continue;
        }
        Of of = new Of(fluent, reference);
        if (!isNamed && value(of, amount).filter(value -> !mayBe(of, value)).isPresent()) {
          continue;
        }
        if (!isNamed && around && !(reference instanceof Reference.None)) {
          thereabouts.add(of);
          continue;
        }
        if (!(reference instanceof Reference.None)) {
          return Optional.of(of);
        }
        broken = broken.or(() -> Optional.of(of));
      }
    }
    if (thereabouts.size() == 1) {
      return Optional.of(thereabouts.get(0));
    }
    // Of several things in a room a number may be meant, of the hob as well as of the light.
    return thereabouts.isEmpty() ? broken : Optional.empty();
  }

  /** Of the numbers that are named those of which there can be more in these words. */
  private static Form alike(Form measure, Form more) {
    Form named = measure.part(0);
    List<Form> parts = new ArrayList<>(measure.parts());
    parts.set(
        0, new Form(named.head(), named.parts().stream().filter(more.parts()::contains).toList()));
    return new Form(measure.head(), parts);
  }

  /** Who turns the heater up wants the room warmer; a lamp that is to be warmer is none. */
  private boolean mayStandForItsPlace(PredicateDeclaration fluent, Form whose) {
    return !(phrases.resolve(whose, "") instanceof Reference.Single single)
        || settables.maySet(fluent, single);
  }

  private boolean mayBe(Of of, double value) {
    return value >= least(of) && value <= measure(of).whole().orElse(Double.MAX_VALUE);
  }

  private List<PredicateDeclaration> fluents(Form named, Form amount) {
    Stream<String> names =
        named.is("_")
            ? situation.home().wording().measures().entrySet().stream()
                .filter(
                    entry ->
                        entry.getValue().whole().isPresent()
                            || amount.is("quantity")
                            || amount.is("number") && isTemperature(entry.getKey()))
                .map(Map.Entry::getKey)
            : named.parts().stream().map(Form::head);
    return names
        .map(vocabulary::predicate)
        .flatMap(Optional::stream)
        .filter(fluent -> fluent.fluent() && fluent.parameters().size() == 1)
        .filter(fluent -> !amount.is("quantity") || isIn(fluent, amount.text(1)))
        .toList();
  }

  /** What has a unit of its own and no whole has no hundredths. */
  private boolean mayBeInPercent(PredicateDeclaration fluent) {
    return fluent.unit().filter(unit -> !unit.equals(PERCENT)).isEmpty()
        || measure(fluent).whole().isPresent();
  }

  /** Of these people say the number alone. */
  private boolean isTemperature(String fluent) {
    return vocabulary
        .predicate(fluent)
        .flatMap(PredicateDeclaration::unit)
        .filter(unit -> unit.equals(CELSIUS) || unit.equals(KELVIN))
        .isPresent();
  }

  /** Who asks wants to know how it is rather than how it is to be. */
  private static List<PredicateDeclaration> measuredFirst(List<PredicateDeclaration> fluents) {
    return fluents.stream().sorted(Comparator.comparing(fluent -> !fluent.observable())).toList();
  }

  private static boolean isIn(PredicateDeclaration fluent, String unit) {
    return fluent.unit().isPresent()
            && unit.equals(Values.FAHRENHEIT)
            && fluent.unit().get().equals(CELSIUS)
        || fluent.unit().isPresent() && isIn(fluent.unit().get(), unit);
  }

  private static boolean isIn(String own, String unit) {
    return own.equals(unit) || own.equals(KELVIN) && unit.equals(CELSIUS) || own.startsWith(unit);
  }

  private Reference whose(PredicateDeclaration fluent, Form whose, boolean around) {
    String type = Relations.typeOf(fluent, 0);
    if (whose.is("_")) {
      return unsaid(fluent, type, around);
    }
    boolean isPlace =
        whose.is("rel")
            || whose.is("here")
            || whose.is("herealone")
            || whose.is("there")
            || whose.is("everywhere")
            || whose.is("from")
            || whose.is("within")
            || whose.is("either")
            || whose.is("each");
    if (!isPlace) {
      Reference said = phrases.resolve(whose, type);
      if (whose.is("it") && said instanceof Reference.None) {
        return unsaid(fluent, type, around);
      }
      return around && said instanceof Reference.Mistyped ? within(whose, type) : said;
    }
    Reference place = place(whose, type);
    boolean isElsewhere = place instanceof Reference.Mistyped || place instanceof Reference.None;
    return around && isElsewhere && !whose.is("herealone") ? thingsAt(whose, type) : place;
  }

  private Reference place(Form where, String type) {
    if (where.is("here") || where.is("herealone")) {
      return situation
          .here()
          .filter(here -> phrases.relations().isA(new Term.Name(here), type))
          .<Reference>map(here -> new Reference.Single(new Term.Name(here)))
          .orElse(new Reference.Mistyped(where));
    }
    if (where.is("each")) {
      return phrases.resolve(
          new Form("and", where.parts().stream().map(NounPhrases::place).toList()), type);
    }
    return where.is("rel") || where.is("from") || where.is("within")
        ? phrases.resolve(NounPhrases.place(where), type)
        : new Reference.Mistyped(where);
  }

  /** What is meant by the brightness in the kitchen: that of the lamps there. */
  private Reference thingsAt(Form where, String type) {
    return phrases.resolve(
        Form.of("np", Form.leaf("all"), Form.of("at", Form.of("noun", Form.leaf(type)), where)),
        type);
  }

  /** A thing of another kind: the place where it is, or what of the kind is there. */
  private Reference within(Form whose, String type) {
    Reference any = phrases.resolve(whose, "");
    if (!(any instanceof Reference.Single single)) {
      return new Reference.Mistyped(whose);
    }
    List<Term.Name> around = phrases.relations().within(single.term(), type);
    if (around.isEmpty()) {
      return new Reference.Mistyped(whose);
    }
    return around.size() == 1
        ? new Reference.Single(around.get(0))
        : new Reference.Several(List.copyOf(around));
  }

  /** Of things that are not named those are meant that are in use; all when none is. */
  private List<Term> inUse(List<Term> things) {
    List<Term> used = things.stream().filter(thing -> !isIdle(thing)).toList();
    return used.isEmpty() ? things : used;
  }

  private boolean isIdle(Term thing) {
    return situation.home().wording().states().stream()
        .filter(state -> state.says().stream().anyMatch(said -> idle.contains(said.text())))
        .filter(state -> phrases.relations().isA(thing, state.of()))
        .anyMatch(state -> phrases.relations().holds(state.holdsWhen(), Map.of("it", thing)));
  }

  /** An oven that was spoken of has no volume. */
  private boolean hasNumber(PredicateDeclaration fluent, Reference.Single single) {
    return settables.maySet(fluent, single)
        || situation.facts().number(fluent(fluent, single.term())).isPresent();
  }

  /** What was spoken of last, or the place itself, or all that are here. */
  private Reference unsaid(PredicateDeclaration fluent, String type, boolean around) {
    Form it = Form.leaf("it");
    Reference last = phrases.resolve(it, type);
    if (last instanceof Reference.Single single && hasNumber(fluent, single)) {
      return last;
    }
    Optional<String> here =
        situation.here().filter(place -> phrases.relations().isA(new Term.Name(place), type));
    if (here.isPresent()) {
      return new Reference.Single(new Term.Name(here.get()));
    }
    if (!around) {
      return new Reference.Mistyped(it);
    }
    Reference all =
        phrases.resolve(Form.of("np", Form.leaf("all"), Form.of("noun", Form.leaf(type))), type);
    if (all instanceof Reference.Several several) {
      List<Term> known =
          inUse(several.terms()).stream()
              .filter(term -> situation.facts().number(fluent(fluent, term)).isPresent())
              .toList();
      return known.isEmpty()
          ? all
          : known.size() == 1 ? phrases.spokenOf(known.get(0)) : new Reference.Several(known);
    }
    return all;
  }
}

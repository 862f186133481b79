package org.maestro.knowledge.belief;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.OnlyKnown;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** A world seen at an instant: ages are reckoned from it. */
public final class View implements Snapshot {

  private static final String VIEW_SHARE = "viewShare";

  private final World world;
  private final Instant now;
  private final Beginning beginning;
  private final Instant oldest;
  private final Optional<Consumer<Belief>> witness;
  private final Optional<Consumer<Object>> told;

  /**
   * @param beginning since when what stands in the home counts
   */
  public View(World world, Instant now, Beginning beginning) {
    this(world, now, beginning, Instant.MIN, Optional.empty(), Optional.empty());
  }

  private View(
      World world,
      Instant now,
      Beginning beginning,
      Instant oldest,
      Optional<Consumer<Belief>> witness,
      Optional<Consumer<Object>> told) {
    this.world = world;
    this.now = now;
    this.beginning = beginning;
    this.oldest = oldest;
    this.witness = witness;
    this.told = told;
  }

  @Override
  public Instant at() {
    return now;
  }

  @Override
  public Snapshot notOlderThan(Duration age) {
    Instant limit = now.minus(age);
    return new View(world, now, beginning, limit.isAfter(oldest) ? limit : oldest, witness, told);
  }

  @Override
  public Snapshot witnessed(Consumer<Belief> seen) {
    return new View(world, now, beginning, oldest, Optional.of(seen), told);
  }

  @Override
  public Optional<Facts> tracing(Consumer<Object> reader) {
    return Optional.of(new View(world, now, beginning, oldest, witness, Optional.of(reader)));
  }

  @Override
  public Optional<Set<Object>> changedSince(Facts other) {
    return other instanceof View before && oldest.equals(before.oldest)
        ? world.changedSince(before.world, before.now, now)
        : Optional.empty();
  }

  /** All that is not described in the home is answered from cells. */
  private Optional<Cell> cell(StateVariable variable) {
    told.ifPresent(reader -> reader.accept(variable));
    return world.cell(variable);
  }

  @Override
  public long version() {
    return world.version();
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return world.described().individuals(className);
  }

  @Override
  public List<List<Term.Name>> alike(Collection<Term.Name> individuals) {
    Set<Term> spokenOf = world.cells().spokenOf();
    return world
        .described()
        .alike(individuals.stream().filter(name -> !spokenOf.contains(name)).toList());
  }

  @Override
  public Truth truth(Formula.Atom asked) {
    if (world.described().isOfClass(asked)) {
      return Truth.of(world.described().isInstance(asked.arguments().get(0), asked.predicate()));
    }
    Optional<PredicateDeclaration> declared = world.declarations().declared(asked.predicate());
    Optional<Formula> derivation = declared.flatMap(PredicateDeclaration::derivedWhen);
    if (derivation.isPresent()) {
      return derived(declared.get(), derivation.get(), asked.arguments());
    }
    Formula.Atom atom = world.declarations().canonical(asked);
    Optional<Cell> cell = cell(world.declarations().variable(atom));
    if (cell.isPresent()) {
      return inCell(cell.get(), atom);
    }
    String function = function(declared, atom.predicate());
    if (world.measures().isTruth(function)) {
      return world.measures().truth(function, asked.arguments(), this);
    }
    if (world.described().holds(atom)) {
      bearWitness(asked);
      return Truth.TRUE;
    }
    if (isDescribedOtherwise(atom)) {
      return Truth.FALSE;
    }
    return declared.flatMap(PredicateDeclaration::observedWhen).isPresent() && isPlaced(asked)
        ? new Sightings(world, this).decided(asked)
        : notKnown(atom);
  }

  /**
   * Tells of what stands in the home alone, which is all of what nobody ever spoke of; and the one
   * value that is known of something.
   */
  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    Optional<PredicateDeclaration> declared = world.declarations().declared(atom.predicate());
    boolean stated =
        declared.isPresent()
            && declared.get().parameters().size() == atom.arguments().size()
            && atom.arguments().size() <= 2
            && !declared.get().fluent()
            && !declared.get().observable()
            && declared.get().derivedWhen().isEmpty()
            && declared.get().observedWhen().isEmpty()
            && declared.get().computedBy().isEmpty()
            && !world.measures().isTruth(atom.predicate());
    if (!stated) {
      return Optional.empty();
    }
    told.ifPresent(reader -> reader.accept(new Relation(atom.predicate())));
    Term.Variable wanted = new Term.Variable(variable);
    if (world.cells().speakOf(atom.predicate())) {
      return isValue(atom, wanted) ? Optional.of(valuesOf(atom, wanted)) : Optional.empty();
    }
    return Optional.of(world.described().related(atom, wanted));
  }

  private static String function(Optional<PredicateDeclaration> declared, String name) {
    return declared.flatMap(PredicateDeclaration::computedBy).orElse(name);
  }

  /** Tells of what is reckoned of the home, where nobody ever said anything else. */
  @Override
  public Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
    Optional<PredicateDeclaration> declared = world.declarations().declared(fluent.name());
    String function = function(declared, fluent.name());
    if (!world.measures().isNumber(function)
        || fluent.arguments().size() != 2
        || world.cells().speakOf(fluent.name())) {
      return Optional.empty();
    }
    told.ifPresent(reader -> reader.accept(new Relation(fluent.name())));
    int place = fluent.arguments().indexOf(new Term.Variable(variable));
    Optional<String> className = declared.flatMap(one -> one.parameters().get(place).className());
    List<Term> arguments = new ArrayList<>(fluent.arguments());
    Set<Term> above = new LinkedHashSet<>();
    for (Term.Name individual : individuals(className.orElse(""))) {
      arguments.set(place, individual);
      OptionalDouble number = world.measures().number(function, List.copyOf(arguments), this);
      if (number.isEmpty() || number.getAsDouble() > 0) {
        above.add(individual);
      }
    }
    return Optional.of(above);
  }

  /** Whether it asks for the value that something has. */
  private boolean isValue(Formula.Atom atom, Term.Variable wanted) {
    return world.declarations().isFunctional(atom.predicate())
        && atom.arguments().size() == 2
        && atom.arguments().get(1).equals(wanted)
        && world.declarations().canonical(atom).equals(atom);
  }

  private Set<Term> valuesOf(Formula.Atom atom, Term.Variable wanted) {
    StateVariable variable = world.declarations().variable(atom);
    Optional<Cell> cell = cell(variable);
    if (cell.isEmpty()) {
      return world.described().related(atom, wanted);
    }
    Optional<Held> value = settled(cell.get()).value();
    value.ifPresent(held -> bearWitness(variable, held, true));
    return value.map(held -> Set.of(held.value())).orElseGet(Set::of);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    StateVariable variable = new StateVariable(fluent.name(), fluent.arguments());
    Optional<PredicateDeclaration> declared = world.declarations().declared(fluent.name());
    Optional<Cell> cell = cell(variable);
    if (cell.isPresent()) {
      Optional<Held> held = settled(cell.get()).value();
      held.ifPresent(value -> bearWitness(variable, value, true));
      if (held.isPresent() || !isShare(declared)) {
        return held.isPresent() && held.get().value() instanceof Term.Number number
            ? OptionalDouble.of(number.value())
            : OptionalDouble.empty();
      }
    }
    OptionalDouble stated = world.described().number(fluent.name(), fluent.arguments());
    if (stated.isPresent()) {
      bearWitness(variable, stated.getAsDouble());
      return stated;
    }
    String function = function(declared, fluent.name());
    return world.measures().isNumber(function)
        ? world.measures().number(function, fluent.arguments(), this)
        : OptionalDouble.empty();
  }

  /**
   * Of a share what was learnt, and is not believed any more, leaves what is stated or computed.
   */
  private static boolean isShare(Optional<PredicateDeclaration> declared) {
    return declared.filter(d -> d.shareOf().isPresent()).isPresent();
  }

  /**
   * At the age at which it ceased to count, a value holds still in one case out of two, at three
   * times the age in one out of four. Stated assumption: things that stayed long stay longer.
   */
  @Override
  public double chanceStill(Formula.Atom asked) {
    Formula.Atom atom = world.declarations().canonical(asked);
    StateVariable variable = world.declarations().variable(atom);
    Term wanted = world.declarations().valueOf(atom);
    return world
        .cell(variable)
        .filter(cell -> !cell.excluded().containsKey(wanted))
        .flatMap(Cell::last)
        .filter(held -> held.value().equals(wanted) && held.expires().isBefore(Instant.MAX))
        .map(held -> chanceStill(held, now))
        .orElse(0.0);
  }

  private static double chanceStill(Held held, Instant now) {
    double good = seconds(Duration.between(held.since(), held.expires()));
    double age = Math.max(0, seconds(Duration.between(held.since(), now)));
    return good > 0 ? good / (good + age) : 0;
  }

  /** What was remembered over a restart may be good for longer than milliseconds can count. */
  private static double seconds(Duration duration) {
    return duration.getSeconds() + duration.getNano() / 1e9;
  }

  @Override
  public Optional<Belief> belief(Formula.Atom asked) {
    Formula.Atom atom = world.declarations().canonical(asked);
    StateVariable variable = world.declarations().variable(atom);
    Optional<Cell> cell = world.cell(variable);
    if (cell.isEmpty()) {
      return world.described().holds(atom)
          ? Optional.of(beginning.belief(Wording.holds(asked, true)))
          : Optional.empty();
    }
    Settled settled = settled(cell.get());
    Optional<Held> excluded =
        Optional.ofNullable(settled.excluded().get(world.declarations().valueOf(atom)));
    Optional<Held> value = settled.value();
    if (value.isPresent()) {
      boolean functional = world.declarations().isFunctional(atom.predicate());
      String fact =
          functional
              ? Wording.value(variable, value.get(), true)
              : Wording.holds(asked, value.get().value().equals(new Term.Truth(true)));
      return Optional.of(belief(fact, value.get()));
    }
    return excluded.map(held -> exclusion(Wording.holds(asked, false), held));
  }

  @Override
  public Optional<Belief> belief(Expression.Fluent fluent) {
    StateVariable variable = new StateVariable(fluent.name(), fluent.arguments());
    Optional<Cell> cell = world.cell(variable);
    if (cell.isPresent()) {
      return settled(cell.get())
          .value()
          .map(held -> belief(Wording.value(variable, held, true), held));
    }
    OptionalDouble stated = world.described().number(fluent.name(), fluent.arguments());
    return stated.isPresent()
        ? Optional.of(
            beginning.belief(Wording.equation(variable, new Term.Number(stated.getAsDouble()))))
        : Optional.empty();
  }

  @Override
  public List<Belief> claims(Formula.Atom asked) {
    Formula.Atom atom = world.declarations().canonical(asked);
    StateVariable variable = world.declarations().variable(atom);
    boolean functional = world.declarations().isFunctional(atom.predicate());
    return claims(
        variable,
        claim ->
            functional
                ? Wording.value(variable, claim.held(), claim.has())
                : Wording.holds(asked, claim.value().equals(new Term.Truth(true))));
  }

  @Override
  public List<Belief> claims(Expression.Fluent fluent) {
    StateVariable variable = new StateVariable(fluent.name(), fluent.arguments());
    return claims(variable, claim -> Wording.value(variable, claim.held(), true));
  }

  private List<Belief> claims(StateVariable variable, Function<Claim, String> wording) {
    return world.cell(variable).stream()
        .flatMap(cell -> Stream.concat(cell.standing().stream(), cell.overruled().stream()))
        .filter(claim -> counts(claim.held()))
        .map(claim -> belief(wording.apply(claim), claim.held()))
        .toList();
  }

  @Override
  public Optional<Term> value(String predicate, List<Term> arguments) {
    StateVariable variable = new StateVariable(predicate, arguments);
    Optional<Cell> cell = cell(variable);
    if (cell.isPresent()) {
      Optional<Held> held = settled(cell.get()).value();
      held.ifPresent(value -> bearWitness(variable, value, true));
      return held.map(Held::value);
    }
    return arguments.size() == 1
        ? world.described().values(arguments.get(0), predicate).stream().findFirst()
        : Optional.empty();
  }

  @Override
  public List<Belief> beliefs() {
    List<Belief> beliefs = new ArrayList<>();
    for (StateVariable variable : world.variables()) {
      Settled settled = settled(world.cell(variable).orElseThrow());
      settled.value().ifPresent(held -> beliefs.add(belief(variable, held, true)));
      settled
          .excluded()
          .values()
          .forEach(held -> beliefs.add(exclusion(Wording.value(variable, held, false), held)));
    }
    beliefs.sort(Comparator.comparing(Belief::fact));
    return List.copyOf(beliefs);
  }

  @Override
  public Optional<Belief> lastKnown(String predicate, List<Term> arguments) {
    StateVariable variable = new StateVariable(predicate, arguments);
    return world.cell(variable).flatMap(Cell::last).map(held -> belief(variable, held, true));
  }

  @Override
  public List<Dispute> disputes() {
    List<Dispute> disputes = new ArrayList<>();
    for (StateVariable variable : world.variables()) {
      new Disputes(variable, world.cell(variable).orElseThrow(), this::counts)
          .dispute()
          .ifPresent(disputes::add);
    }
    return List.copyOf(disputes);
  }

  private Truth derived(PredicateDeclaration declared, Formula derivation, List<Term> arguments) {
    Map<String, Term> bindings = new HashMap<>();
    for (int i = 0; i < Math.min(arguments.size(), declared.parameters().size()); i++) {
      bindings.put(declared.parameters().get(i).name(), arguments.get(i));
    }
    return declared.observable()
        ? new Evaluation(this).truth(derivation, bindings)
        : Truth.of(new Evaluation(new OnlyKnown(this)).truth(derivation, bindings) == Truth.TRUE);
  }

  private Truth inCell(Cell cell, Formula.Atom atom) {
    Term wanted = world.declarations().valueOf(atom);
    Settled settled = settled(cell);
    StateVariable variable = world.declarations().variable(atom);
    if (settled.value().isPresent()) {
      bearWitness(variable, settled.value().get(), true);
      return Truth.of(settled.value().get().value().equals(wanted));
    }
    if (settled.excluded().containsKey(wanted)) {
      bearWitness(variable, settled.excluded().get(wanted), false);
      return Truth.FALSE;
    }
    return notKnown(atom);
  }

  /** Whether the place of the atom's first argument is known, so that it may decide the atom. */
  private boolean isPlaced(Formula.Atom atom) {
    if (atom.arguments().isEmpty()) {
      return false;
    }
    Term subject = atom.arguments().get(0);
    return value(Declarations.POSITION, List.of(subject)).isPresent()
        || !world.described().values(subject, Declarations.POSE).isEmpty();
  }

  private boolean isDescribedOtherwise(Formula.Atom atom) {
    StateVariable variable = world.declarations().variable(atom);
    return world.declarations().isFunctional(atom.predicate())
        && world.described().describes(variable);
  }

  private Truth notKnown(Formula.Atom atom) {
    return world.declarations().isObservable(atom.predicate()) ? Truth.UNKNOWN : Truth.FALSE;
  }

  private void bearWitness(StateVariable variable, Held held, boolean has) {
    if (witness.isPresent()) {
      witness.get().accept(belief(variable, held, has));
    }
  }

  /** Of what stands in the home; what is symmetric may stand there with either thing. */
  private void bearWitness(Formula.Atom stated) {
    witness.ifPresent(
        seen ->
            stated.arguments().stream()
                .filter(subject -> !world.described().values(subject, stated.predicate()).isEmpty())
                .findFirst()
                .flatMap(
                    subject -> beginning.belief(Wording.holds(stated, true), subject, world.home()))
                .ifPresent(seen));
  }

  private void bearWitness(StateVariable stated, double value) {
    witness.ifPresent(
        seen ->
            beginning
                .belief(
                    Wording.equation(stated, new Term.Number(value)),
                    stated.arguments().get(0),
                    world.home())
                .ifPresent(seen));
  }

  private Settled settled(Cell cell) {
    return cell.settled(this::counts);
  }

  private boolean counts(Held held) {
    return held.isFresh(now) && !held.since().isBefore(oldest);
  }

  /** With the share of the place that its source covered: what it said, or what it has in view. */
  private Belief exclusion(String fact, Held held) {
    List<Term> view = List.of(new Term.Name(held.source().agent()), held.value());
    OptionalDouble share =
        held.coveredShare().isPresent() || !world.measures().isNumber(VIEW_SHARE)
            ? held.coveredShare()
            : world.measures().number(VIEW_SHARE, view, this);
    boolean sees = share.isPresent() && share.getAsDouble() > 0;
    return new Belief(
        fact,
        held.source(),
        held.since(),
        held.confidence(),
        sees ? share : OptionalDouble.empty());
  }

  private static Belief belief(StateVariable variable, Held held, boolean has) {
    return belief(Wording.value(variable, held, has), held);
  }

  private static Belief belief(String fact, Held held) {
    return new Belief(fact, held.source(), held.since(), held.confidence());
  }
}

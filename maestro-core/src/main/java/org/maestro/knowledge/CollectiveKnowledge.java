package org.maestro.knowledge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.apache.jena.sparql.core.Quad;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/**
 * The collective knowledge base (M12): an RDF dataset with provenance, and beside it plain indexes from which snapshots answer. Time of
 * receipt and ages come from the clock. Thread-safe: writers wait for each other, readers for nobody.
 */
public final class CollectiveKnowledge implements KnowledgeBase {

  private static final Source HOME = new Source(Source.Kind.DESCRIBED, "home");

  private final Clock clock;
  private final Function<Home, Measures> measures;
  private final GraphStorage storage;
  private final Instant opened;
  private final Lock writing = new ReentrantLock();
  private final List<Consumer<Change>> listeners = new CopyOnWriteArrayList<>();
  private final History history = new History();
  private final Map<String, Set<StateVariable>> statements = new TreeMap<>();
  private volatile World world;
  private long serial;

  /** A knowledge base in memory. */
  public CollectiveKnowledge(Home home, Clock clock) {
    this(home, clock, HomeMeasures::new, new MemoryStorage());
  }

  CollectiveKnowledge(
      Home home, Clock clock, Function<Home, Measures> measures, GraphStorage storage) {
    this.clock = clock;
    this.measures = measures;
    this.storage = storage;
    this.opened = clock.instant();
    this.world = World.of(home, measures.apply(home));
    Graphs graphs = new Graphs(home);
    storage.replace(graphs.vocabularyGraph(), graphs.vocabulary());
    storage.replace(
        graphs.homeGraph(),
        home.individuals().values().stream()
            .filter(individual -> !home.devices().containsKey(individual.name()))
            .flatMap(individual -> graphs.individual(individual).stream())
            .toList());
    home.devices().values().forEach(device -> store(graphs, device));
  }

  @Override
  public Home home() {
    return world.home();
  }

  @Override
  public void describe(Device device) {
    guarded(
        () -> {
          Home home = world.home();
          if (device.equals(home.devices().get(device.id()))) {
            return unchanged(HOME);
          }
          Map<String, Individual> individuals = new TreeMap<>(home.individuals());
          individuals.put(device.id(), device.individual());
          Map<String, Device> devices = new TreeMap<>(home.devices());
          devices.put(device.id(), device);
          Home changed =
              new Home(home.iri(), home.label(), home.vocabulary(), individuals, devices);
          world = world.with(changed, measures.apply(changed), world.version() + 1);
          store(new Graphs(changed), device);
          Source source = new Source(Source.Kind.DESCRIBED, device.id());
          return tell(new Change(world.version(), source, List.of()));
        });
  }

  @Override
  public void state(Source source, List<String> facts) {
    List<Fact> parsed = facts.stream().map(text -> parsed(text, source.agent())).toList();
    guarded(
        () ->
            write(
                source,
                draft -> {
                  withdraw(draft, source, parsed);
                  return parsed;
                }));
  }

  @Override
  public Change learn(FeatureRun run) {
    boolean expects = run.succeeded() && run.feature().learns().isEmpty();
    Source.Kind kind = expects ? Source.Kind.EXPECTED : Source.Kind.OBSERVED;
    return guarded(() -> write(new Source(kind, run.member()), draft -> lesson(draft, run)));
  }

  @Override
  public void lost(String member) {
    Term name = new Term.Name(member);
    guarded(
        () ->
            write(
                new Source(Source.Kind.OBSERVED, member),
                draft -> {
                  world.variables().stream()
                      .filter(variable -> isOf(member, name, variable))
                      .forEach(variable -> forget(draft, variable));
                  statements.remove(member);
                  return List.of();
                }));
  }

  @Override
  public Snapshot snapshot() {
    return view(world);
  }

  @Override
  public void watch(Consumer<Change> listener) {
    listeners.add(listener);
  }

  /**
   * The latest beliefs of what the fact speaks of, oldest first, at most 16: for a functional predicate all its values for the
   * same thing. Statements that lost against another source are among them.
   *
   * @param fact a ground atom, or a fluent
   */
  public List<Belief> history(String fact) {
    Fact parsed = parsed(fact, "the reader");
    return guarded(() -> history.of(new Draft(world, opened, () -> 0).variable(atom(parsed))));
  }

  /** Rows of a SPARQL SELECT over the dataset, each by variable. */
  public List<Map<String, String>> select(String query) {
    return storage.select(query);
  }

  @Override
  public void close() {
    storage.close();
  }

  private List<Fact> lesson(Draft draft, FeatureRun run) {
    Snapshot present = view(world);
    Snapshot before = run.before().orElse(present);
    if (run.succeeded()) {
      Map<String, Term> bindings = new LinkedHashMap<>(run.bindings());
      bindings.put("self", new Term.Name(run.member()));
      bindings.putAll(run.outputs());
      return run.feature().learns().isPresent()
          ? EffectReader.facts(run.feature().learns().get(), bindings, present, present)
          : EffectReader.facts(run.feature().effect(), bindings, before, present);
    }
    EffectReader.touched(run.feature().effect(), run.bindings(), before).stream()
        .filter(atom -> isUncertain(atom.predicate()))
        .map(draft::variable)
        .filter(variable -> !isOwnWord(run.member(), variable))
        .forEach(variable -> forget(draft, variable));
    return run.refs().stream().map(ref -> fact(ref, run.member())).toList();
  }

  /** Whether a step that failed leaves it open; plain closed-world facts stay as they are. */
  private boolean isUncertain(String predicate) {
    Declarations declarations = world.declarations();
    return declarations.isFluent(predicate)
        || declarations.isFunctional(predicate)
        || declarations.isObservable(predicate)
        || world.cells().containsKey(predicate) && isNumeric(predicate);
  }

  private boolean isNumeric(String predicate) {
    return world.cells().get(predicate).values().stream()
        .flatMap(cell -> cell.value().stream())
        .anyMatch(held -> held.value() instanceof Term.Number);
  }

  /** A member goes on telling its own values, whatever became of the step. */
  private boolean isOwnWord(String member, StateVariable variable) {
    return world
        .cell(variable)
        .flatMap(Cell::value)
        .filter(held -> held.source().equals(new Source(Source.Kind.STATED, member)))
        .filter(held -> isSubject(new Term.Name(member), variable))
        .isPresent();
  }

  private boolean isOf(String member, Term name, StateVariable variable) {
    Optional<Held> value = world.cell(variable).flatMap(Cell::value);
    boolean saidOfItself =
        isSubject(name, variable)
            && value.filter(held -> held.source().agent().equals(member)).isPresent();
    boolean carried =
        world.declarations().isObservable(variable.predicate())
            && value.filter(held -> held.value().equals(name)).isPresent();
    return saidOfItself || carried;
  }

  private static boolean isSubject(Term name, StateVariable variable) {
    return variable.arguments().stream().findFirst().filter(name::equals).isPresent();
  }

  /** What the member said before and does not say any more is not known any more. */
  private void withdraw(Draft draft, Source source, List<Fact> facts) {
    if (source.kind() != Source.Kind.STATED
        || !world.home().devices().containsKey(source.agent())) {
      return;
    }
    Set<StateVariable> said = new LinkedHashSet<>();
    facts.forEach(fact -> said.add(draft.variable(atom(fact))));
    Set<StateVariable> before = statements.put(source.agent(), said);
    if (before != null) {
      before.stream()
          .filter(variable -> !said.contains(variable))
          .filter(
              variable ->
                  world
                      .cell(variable)
                      .flatMap(Cell::value)
                      .filter(held -> held.source().equals(source))
                      .isPresent())
          .forEach(variable -> forget(draft, variable));
    }
  }

  private void forget(Draft draft, StateVariable variable) {
    new PositionKeeping(draft, this::view).forget(variable);
  }

  private Change write(Source source, Function<Draft, List<Fact>> facts) {
    Instant now = clock.instant();
    long first = serial;
    long[] next = {first};
    Draft draft = new Draft(world, now, () -> next[0]++);
    new PositionKeeping(draft, this::view).write(facts.apply(draft), source);
    Outcome outcome = Outcome.of(draft, now);
    serial = next[0];
    if (outcome.news().isEmpty() && outcome.gone().isEmpty()) {
      return unchanged(source);
    }
    World written = draft.world();
    boolean isNews = !outcome.facts().isEmpty();
    world = isNews ? written : written.atVersion(world.version());
    store(outcome);
    Change change = new Change(world.version(), source, outcome.facts());
    return isNews ? tell(change) : change;
  }

  private void store(Outcome outcome) {
    Graphs graphs = new Graphs(world.home());
    List<Quad> removed = new ArrayList<>();
    List<GraphStorage.Subject> forgotten = new ArrayList<>();
    List<Quad> added = new ArrayList<>();
    outcome.gone().forEach(gone -> removed.addAll(graphs.current(gone)));
    for (Outcome.News news : outcome.news()) {
      if (news.current()) {
        added.addAll(graphs.current(news));
      }
      added.addAll(graphs.provenance(news));
      Belief belief = new Belief(news.fact(), news.held().source(), news.held().since());
      history
          .add(news.variable(), belief, news.held().serial())
          .ifPresent(
              old ->
                  forgotten.add(
                      new GraphStorage.Subject(
                          graphs.observationsGraph(), graphs.observation(old))));
    }
    storage.commit(removed, forgotten, added);
  }

  private void store(Graphs graphs, Device device) {
    storage.replace(graphs.memberGraph(device.id()), graphs.individual(device.individual()));
  }

  private Change tell(Change change) {
    listeners.forEach(listener -> listener.accept(change));
    return change;
  }

  private Change unchanged(Source source) {
    return new Change(world.version(), source, List.of());
  }

  private Snapshot view(World seen) {
    return new View(seen, clock.instant(), opened);
  }

  private <T> T guarded(Supplier<T> work) {
    writing.lock();
    try {
      return work.get();
    } finally {
      writing.unlock();
    }
  }

  private static Formula.Atom atom(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      return holds.atom();
    } else if (fact instanceof Fact.Excluded excluded) {
      return excluded.atom();
    } else if (fact instanceof Fact.Unknown unknown) {
      return unknown.atom();
    }
    Fact.Equation equation = (Fact.Equation) fact;
    return new Formula.Atom(equation.fluent().name(), equation.fluent().arguments());
  }

  private static Fact parsed(String text, String speaker) {
    try {
      Fact fact = SlParser.fact(text);
      if (!atom(fact).isGround()) {
        throw new KnowledgeException(
            "The fact " + text + " by " + speaker + " has variables; name the things in it.");
      }
      return fact;
    } catch (SlSyntaxException e) {
      throw new KnowledgeException(
          "The fact " + text + " by " + speaker + " is not MAESTRO-SL. " + e.getMessage(), e);
    }
  }

  private static Fact fact(FeatureRun.Learnt learnt, String member) {
    Formula.Atom atom = atom(parsed(learnt.fact(), member));
    if (learnt.value() instanceof Term.Truth truth) {
      return truth.value() ? new Fact.Holds(atom) : new Fact.Excluded(atom);
    }
    return new Fact.Equation(
        new Expression.Fluent(atom.predicate(), atom.arguments()), learnt.value());
  }
}

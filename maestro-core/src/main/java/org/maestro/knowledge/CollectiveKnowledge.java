package org.maestro.knowledge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.apache.jena.sparql.core.Quad;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The collective knowledge base (M12): an RDF dataset with provenance, and beside it plain indexes
 * from which snapshots answer. Time of receipt and ages come from the clock. Thread-safe: writers
 * wait for each other, readers for nobody.
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
  private final Statements statements = new Statements();
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
          Home changed = home.with(device);
          world = world.with(changed, measures.apply(changed), world.version() + 1);
          store(new Graphs(changed), device);
          Source source = new Source(Source.Kind.DESCRIBED, device.id());
          return tell(new Change(world.version(), source, List.of()));
        });
  }

  @Override
  public void state(Source source, List<String> facts) {
    List<Fact> read = facts.stream().map(text -> FactReader.read(text, source.agent())).toList();
    guarded(
        () ->
            write(
                source,
                draft -> {
                  Set<StateVariable> said = new LinkedHashSet<>();
                  read.forEach(fact -> said.add(draft.variable(FactReader.atom(fact))));
                  statements
                      .withdrawn(world, source, said)
                      .forEach(variable -> forget(draft, variable));
                  return read;
                }));
  }

  @Override
  public Change learn(FeatureRun run) {
    return guarded(
        () -> {
          Lesson lesson = new Lesson(world, view(world), run);
          return write(
              lesson.source(), draft -> lesson.facts(draft, variable -> forget(draft, variable)));
        });
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
                  statements.forget(member);
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
   * The latest beliefs of what the fact speaks of, oldest first, at most 16: for a functional
   * predicate all its values for the same thing. Statements that lost against another source are
   * among them.
   *
   * @param fact a ground atom, or a fluent
   */
  public List<Belief> history(String fact) {
    Formula.Atom atom = FactReader.atom(FactReader.read(fact, "the reader"));
    return guarded(() -> history.of(new Draft(world, opened, () -> 0).variable(atom)));
  }

  /** Rows of a SPARQL SELECT over the dataset, each by variable. */
  public List<Map<String, String>> select(String query) {
    return storage.select(query);
  }

  @Override
  public void close() {
    storage.close();
  }

  private boolean isOf(String member, Term name, StateVariable variable) {
    Optional<Held> value = world.cell(variable).flatMap(Cell::value);
    boolean saidOfItself =
        variable.isAbout(name)
            && value.filter(held -> held.source().agent().equals(member)).isPresent();
    boolean carried =
        world.declarations().isObservable(variable.predicate())
            && value.filter(held -> held.value().equals(name)).isPresent();
    return saidOfItself || carried;
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
}

package org.maestro.knowledge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.apache.jena.graph.NodeFactory;
import org.apache.jena.sparql.core.Quad;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.History;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.MemberWord;
import org.maestro.knowledge.api.QueryAnswer;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.knowledge.api.Store;
import org.maestro.knowledge.belief.Ageing;
import org.maestro.knowledge.belief.Beginning;
import org.maestro.knowledge.belief.Cell;
import org.maestro.knowledge.belief.Cells;
import org.maestro.knowledge.belief.Conclusions;
import org.maestro.knowledge.belief.Confidence;
import org.maestro.knowledge.belief.Draft;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.knowledge.belief.Held;
import org.maestro.knowledge.belief.HomeMeasures;
import org.maestro.knowledge.belief.LastWords;
import org.maestro.knowledge.belief.Measures;
import org.maestro.knowledge.belief.Outcome;
import org.maestro.knowledge.belief.PositionKeeping;
import org.maestro.knowledge.belief.Remembered;
import org.maestro.knowledge.belief.Statements;
import org.maestro.knowledge.belief.View;
import org.maestro.knowledge.belief.Voice;
import org.maestro.knowledge.belief.World;
import org.maestro.knowledge.history.HistoryFile;
import org.maestro.knowledge.history.StoredHistory;
import org.maestro.knowledge.learning.Lesson;
import org.maestro.knowledge.learning.Sights;
import org.maestro.knowledge.rdf.ForeignQuery;
import org.maestro.knowledge.rdf.GraphStorage;
import org.maestro.knowledge.rdf.GraphStorageFactory;
import org.maestro.knowledge.rdf.Graphs;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Fact;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.storage.WritingAside;

/**
 * The collective knowledge base (Three-layered architecture, 2; M12): an RDF dataset with
 * provenance, and beside it plain indexes from which snapshots answer. Time of receipt and ages
 * come from the clock. Thread-safe: writers wait for each other, readers for nobody.
 */
public final class CollectiveKnowledge implements KnowledgeBase {

  private static final Voice TIME = new Voice(new Source(Source.Kind.DESCRIBED, "time"), 1);

  /** Of memory, measured: a dataset in memory has each of its triples in six orders. */
  private static final long STATEMENT_BYTES_WITH_DATASET = 6 << 10;

  private static final long STATEMENT_BYTES = 512;
  private static final String HISTORY = "Statements of the history";
  private static final Source HOME = new Source(Source.Kind.DESCRIBED, Source.HOME);

  private final Clock clock;
  private final DescribedDevices devices;
  private final GraphStorage storage;
  private final KnowledgeSettings settings;
  private final Beginning beginning;
  private final Lock writing = new ReentrantLock();
  private final List<Consumer<Change>> listeners = new CopyOnWriteArrayList<>();
  private final History history;
  private final Optional<HistoryFile> file;
  private final WritingAside aside;
  private final Statements statements = new Statements();
  private final Conclusions conclusions = new Conclusions();
  private final LastWords lastWords = new LastWords();
  private final Sights sights = new Sights();
  private final SpokenPoints spoken = new SpokenPoints();
  private final Ageing ageing;
  private volatile World world;

  /** The home as its file has it, without what has joined; guarded by the lock for writing. */
  private Home asDescribed;

  private long serial;

  /** A knowledge base in memory. */
  public CollectiveKnowledge(Home home, Clock clock) {
    this(
        home,
        clock,
        HomeMeasures::new,
        GraphStorageFactory.open(Store.IN_MEMORY),
        KnowledgeSettings.inMemory());
  }

  CollectiveKnowledge(
      Home home,
      Clock clock,
      Function<Home, Measures> measures,
      GraphStorage storage,
      KnowledgeSettings settings) {
    this.history =
        new History(settings, storage.isLasting() ? STATEMENT_BYTES : STATEMENT_BYTES_WITH_DATASET);
    this.file = settings.directory().map(place -> new HistoryFile(place, settings.kept()));
    this.aside =
        file.isEmpty() || clock.isStepped()
            ? WritingAside.atOnce(HISTORY)
            : WritingAside.begin(HISTORY);
    this.clock = clock;
    this.devices = new DescribedDevices(measures, storage);
    this.storage = storage;
    this.settings = settings;
    this.beginning = new Beginning(clock.instant(), home);
    this.ageing = new Ageing(clock, this::age);
    this.world = World.of(home, measures.apply(home));
    this.asDescribed = home;
    Graphs graphs = new Graphs(home);
    storage.replace(graphs.vocabularyGraph(), graphs.vocabulary());
    devices.store(graphs, home);
    home.devices().values().forEach(device -> devices.store(graphs, device));
  }

  /**
   * A knowledge base that knows what was said before a restart. What was believed then is not
   * believed any more, only remembered: nobody can tell what happened meanwhile.
   *
   * @throws KnowledgeException when the directory or the store of its settings cannot be used
   */
  public static CollectiveKnowledge open(Home home, Clock clock, KnowledgeSettings settings) {
    CollectiveKnowledge knowledge =
        new CollectiveKnowledge(
            home, clock, HomeMeasures::new, GraphStorageFactory.open(settings.store()), settings);
    knowledge.restore();
    return knowledge;
  }

  void restore() {
    if (file.isEmpty() && !storage.isLasting()) {
      return;
    }
    Instant now = clock.instant();
    Graphs graphs = new Graphs(world.home());
    StoredHistory stored = new StoredHistory(storage, graphs);
    Map<Long, Outcome.News> read = new LinkedHashMap<>();
    Cells[] cells = {world.cells()};
    Consumer<HistoryFile.Line> remember =
        line -> {
          Remembered old = Remembered.of(world.declarations(), line.belief(), serial++);
          if (line.believed() && old.has()) {
            cells[0] = cells[0].with(old.variable(), Cell.remembered(old.held()));
          }
          read.put(old.held().serial(), old.news());
          note(old.news(), line.belief(), now).forEach(gone -> read.remove(gone.serial()));
        };
    file.ifPresentOrElse(
        kept -> kept.read(now, remember),
        () -> stored.read(now.minus(settings.kept()), now).forEach(remember));
    world = world.with(cells[0], world.version());
    List<Quad> statements =
        read.values().stream().flatMap(news -> graphs.provenance(news).stream()).toList();
    List<GraphStorage.Edit> edits = new ArrayList<>();
    edits.add(new GraphStorage.Edit.Replacement(graphs.worldGraph(), List.of()));
    edits.add(
        new GraphStorage.Edit.Replacement(
            graphs.observationsGraph(), statements.stream().map(Quad::asTriple).toList()));
    stored
        .otherMembers(
            world.home().devices().keySet().stream()
                .map(member -> graphs.memberGraph(member).getURI())
                .toList())
        .forEach(
            gone ->
                edits.add(
                    new GraphStorage.Edit.Replacement(NodeFactory.createURI(gone), List.of())));
    storage.apply(edits);
  }

  @Override
  public Home home() {
    return world.home();
  }

  @Override
  public void describe(Device device) {
    guarded(
        () -> {
          World before = world;
          world = devices.described(before, device);
          Change change = tellOf(device.id(), before);
          noLongerLost(device.id());
          return change;
        });
  }

  @Override
  public void permit(Map<String, Individual> permissions) {
    guarded(
        () -> {
          asDescribed = asDescribed.withPermissions(permissions);
          devices.store(new Graphs(asDescribed), asDescribed);
          return changed(world.home().withPermissions(permissions));
        });
  }

  @Override
  public void admit(Group group) {
    guarded(
        () -> {
          World before = world;
          world = devices.changed(before, before.home().with(group));
          devices.store(new Graphs(world.home()), group);
          return tellOf(group.id(), before);
        });
  }

  @Override
  public void dismiss(String group) {
    guarded(
        () -> {
          World before = world;
          world = devices.changed(before, before.home().withoutGroup(group));
          devices.remove(new Graphs(world.home()), group);
          return tellOf(group, before);
        });
  }

  @Override
  public void admit(NamedPoints points) {
    guarded(
        () -> {
          World before = world;
          NamedPoints coming = spoken.come(points, before.home());
          return coming.isEmpty() ? unchanged(HOME) : changed(coming.in(before.home()));
        });
  }

  @Override
  public void dismiss(NamedPoints points) {
    guarded(
        () -> {
          NamedPoints going = spoken.go(points);
          if (going.isEmpty()) {
            return unchanged(HOME);
          }
          write(
              new Voice(HOME, 1),
              (draft, positions) -> {
                going.points().stream()
                    .map(point -> new Term.Name(point.name()))
                    .forEach(name -> forget(name, positions));
                return List.of();
              });
          return changed(going.notIn(world.home()));
        });
  }

  private void forget(Term name, PositionKeeping positions) {
    world.variables().stream()
        .filter(
            variable ->
                variable.arguments().contains(name)
                    || world
                        .cell(variable)
                        .flatMap(Cell::value)
                        .filter(held -> held.value().equals(name))
                        .isPresent())
        .forEach(positions::forget);
  }

  private Change changed(Home home) {
    world = devices.changed(world, home);
    return tell(new Change(world.version(), HOME, List.of()));
  }

  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private Change tellOf(String device, World before) {
    return world.home() == before.home()
        ? unchanged(HOME)
        : tell(new Change(world.version(), new Source(Source.Kind.DESCRIBED, device), List.of()));
  }

  @Override
  public void state(Source source, List<String> facts) {
    List<Fact> read = facts.stream().map(text -> FactReader.read(text, source.agent())).toList();
    state(source, read, Optional.empty());
  }

  @Override
  public void state(String member, MemberWord word) {
    List<Fact> read = word.facts().stream().map(text -> FactReader.read(text, member)).toList();
    state(new Source(Source.Kind.STATED, member), read, Optional.of(word));
  }

  private void state(Source source, List<Fact> facts, Optional<MemberWord> word) {
    guarded(
        () -> {
          World before = world;
          boolean isWhole = word.map(MemberWord::isWhole).orElse(true);
          World base = isWhole ? devices.telling(before, source, facts) : before;
          List<Fact> said = devices.others(before, source, facts);
          word.filter(MemberWord::isWhole).ifPresent(now -> lastWords.heard(source.agent(), now));
          Predicate<StateVariable> isMeant =
              variable -> word.map(w -> w.isOf(variable.predicate())).orElse(true);
          Predicate<StateVariable> isNews =
              variable ->
                  word.filter(w -> !lastWords.takes(source.agent(), variable, w.moment()))
                      .isEmpty();
          Change change =
              write(
                  base,
                  Confidence.voice(base.home(), source),
                  (draft, positions) ->
                      statements.take(source, said, draft, positions, isMeant, isNews));
          if (isWhole) {
            world = devices.withoutWhatIsGone(world, source, facts);
          }
          tellOf(source.agent(), before);
          return change;
        });
  }

  @Override
  public void condition(String member, MemberCondition now) {
    guarded(
        () -> {
          Snapshot before = view(world);
          List<Fact> news =
              now.facts(member).stream()
                  .filter(
                      fact ->
                          !(fact instanceof Fact.Excluded excluded)
                              || before.truth(excluded.atom()) == Truth.TRUE)
                  .toList();
          return write(seen(member), (draft, positions) -> news);
        });
  }

  /** One that has described itself anew is there. */
  private void noLongerLost(String member) {
    if (view(world).truth(MemberCondition.lost(member)) == Truth.TRUE) {
      Fact found = new Fact.Excluded(MemberCondition.lost(member));
      write(seen(member), (draft, positions) -> List.of(found));
    }
  }

  /** What is seen of a member is none of the values that it tells, all of them each time. */
  private static Voice seen(String member) {
    return new Voice(new Source(Source.Kind.OBSERVED, member), 1);
  }

  @Override
  public void believe(Source source, Map<String, Double> sureness) {
    Map<Fact, Double> read = new LinkedHashMap<>();
    sureness.forEach((text, sure) -> read.put(FactReader.read(text, source.agent()), sure));
    guarded(
        () ->
            write(
                new Voice(source, 1),
                (draft, positions) -> conclusions.take(source, read, draft, positions)));
  }

  @Override
  public Change learn(FeatureRun run) {
    return guarded(
        () -> {
          Snapshot present = view(world);
          Lesson lesson = new Lesson(world, present, run, lastWords);
          Source itself = new Source(Source.Kind.STATED, run.member());
          Change change =
              write(
                  Confidence.voice(world.home(), lesson.source(), run, present),
                  (draft, positions) -> {
                    List<Fact> facts = lesson.facts(draft, positions);
                    positions.write(lesson.ownWords(), Confidence.voice(world.home(), itself));
                    sights.note(run, facts, world, present);
                    if (lesson.source().kind() == Source.Kind.EXPECTED) {
                      statements.expects(world, run.member(), facts);
                    }
                    return facts;
                  });
          World before = world;
          world = devices.recalling(before, run);
          tellOf(run.member(), before);
          return change.with(lesson.reported()).denying(lesson.denials());
        });
  }

  @Override
  public void lost(String member) {
    Term name = new Term.Name(member);
    guarded(
        () ->
            write(
                seen(member),
                (draft, positions) -> {
                  world.variables().stream()
                      .filter(variable -> isOf(member, name, variable))
                      .forEach(positions::forget);
                  statements.forget(world, member, positions);
                  lastWords.forget(member);
                  return world.home().devices().containsKey(member)
                      ? List.of(new Fact.Holds(MemberCondition.lost(member)))
                      : List.of();
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

  @Override
  public List<Belief> history(String fact) {
    Fact read = FactReader.read(fact, "the reader");
    return guarded(() -> history.of(world.declarations().spokenOf(read)));
  }

  @Override
  public Optional<Belief> lastKnown(String fact) {
    World seen = world;
    StateVariable variable = seen.declarations().spokenOf(FactReader.read(fact, "the reader"));
    return view(seen).lastKnown(variable.predicate(), variable.arguments());
  }

  @Override
  public QueryAnswer query(String sparql) {
    return ForeignQuery.of(sparql).ask(storage);
  }

  /** Rows of a SPARQL SELECT over the dataset, each by variable. */
  public List<Map<String, String>> select(String query) {
    return storage.select(query);
  }

  @Override
  public void close() {
    ageing.close();
    guarded(
        () -> {
          aside.close();
          file.ifPresent(HistoryFile::close);
          return HOME;
        });
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

  private Change write(Voice voice, Lessons lessons) {
    return write(world, voice, lessons);
  }

  /**
   * @param base what is known before; readers see it with what is written
   */
  private Change write(World base, Voice voice, Lessons lessons) {
    Instant now = clock.instant();
    long first = serial;
    long[] next = {first};
    Draft draft = new Draft(base, now, () -> next[0]++);
    PositionKeeping positions = new PositionKeeping(draft, this::view);
    List<Fact> facts = lessons.read(draft, positions);
    positions.write(facts, voice);
    if (facts.stream().anyMatch(Fact.Equation.class::isInstance)) {
      sights.ended(view(draft.world())).forEach(positions::forget);
    }
    draft.goOn(statements::isStillSaid);
    Outcome outcome = Outcome.of(draft, now);
    serial = next[0];
    Source source = voice.source();
    if (draft.touched().isEmpty() && outcome.news().isEmpty()) {
      world = base;
      return unchanged(source);
    }
    World written = draft.world();
    boolean isNews = !outcome.facts().isEmpty();
    world = isNews ? written : written.with(written.cells(), base.version());
    store(outcome, first, now);
    ageing.expect(draft.nextExpiry());
    Change change = new Change(world.version(), source, outcome.facts(), outcome.expected());
    return isNews ? tell(change) : change;
  }

  /** What is too old to count is taken away, and those who watch are told. */
  private void age() {
    guarded(
        () -> {
          Change change =
              write(
                  TIME,
                  (draft, positions) -> {
                    world.cells().forEach((variable, cell) -> positions.age(variable, cell));
                    return List.of();
                  });
          ageing.expect(world.nextExpiry());
          return change;
        });
  }

  private void store(Outcome outcome, long first, Instant now) {
    if (outcome.news().isEmpty() && outcome.gone().isEmpty()) {
      return;
    }
    Graphs graphs = new Graphs(world.home());
    List<Quad> removed = new ArrayList<>();
    List<GraphStorage.Subject> forgotten = new ArrayList<>();
    List<Quad> added = new ArrayList<>();
    outcome.gone().forEach(gone -> removed.addAll(graphs.current(gone)));
    for (Outcome.News news : outcome.news()) {
      if (news.current()) {
        added.addAll(graphs.current(news));
      }
      Held held = news.held();
      if (held.serial() >= first) {
        added.addAll(graphs.provenance(news));
        Belief belief = new Belief(news.fact(), held.source(), held.since(), held.confidence());
        HistoryFile.Line line = new HistoryFile.Line(belief, news.current());
        file.ifPresent(f -> aside.add(belief.fact().length(), () -> f.write(line, now)));
        for (History.Note old : note(news, belief, now)) {
          forgotten.add(
              new GraphStorage.Subject(
                  graphs.observationsGraph(), graphs.observation(old.serial())));
        }
      }
    }
    storage.commit(removed, forgotten, added);
  }

  private List<History.Note> note(Outcome.News news, Belief belief, Instant now) {
    return history.add(
        new History.Note(news.variable(), belief, news.current(), news.held().serial()), now);
  }

  private Change tell(Change change) {
    listeners.forEach(listener -> listener.accept(change));
    return change;
  }

  private Change unchanged(Source source) {
    return new Change(world.version(), source, List.of());
  }

  private Snapshot view(World seen) {
    return new View(seen, clock.instant(), beginning);
  }

  private <T> T guarded(Supplier<T> work) {
    writing.lock();
    try {
      return work.get();
    } finally {
      writing.unlock();
    }
  }

  /** The content of a write: what it makes of the draft, and the facts that it has to say. */
  @FunctionalInterface
  private interface Lessons {
    List<Fact> read(Draft draft, PositionKeeping positions);
  }
}

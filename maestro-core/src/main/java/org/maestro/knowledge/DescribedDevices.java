package org.maestro.knowledge;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.belief.Measures;
import org.maestro.knowledge.belief.ToldThings;
import org.maestro.knowledge.belief.World;
import org.maestro.knowledge.rdf.GraphStorage;
import org.maestro.knowledge.rdf.Graphs;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Fact;

/**
 * The home as devices describe themselves and tell of their things: makes of each such word the
 * world in which it is so, and keeps its statements in the dataset. One writer at a time.
 */
final class DescribedDevices {

  private final Function<Home, Measures> measures;
  private final GraphStorage storage;
  private final ToldThings things = new ToldThings();

  DescribedDevices(Function<Home, Measures> measures, GraphStorage storage) {
    this.measures = measures;
    this.storage = storage;
  }

  /**
   * The device describes itself so.
   *
   * @throws KnowledgeException when it contradicts what is there; all is as it was then
   */
  World described(World base, Device device) {
    World changed = with(base, things.with(device));
    things.described(device);
    return changed;
  }

  /** A device that speaks of itself tells which things are there. */
  World telling(World base, Source source, List<Fact> facts) {
    Optional<Device> speaker = speaker(base, source);
    speaker.ifPresent(device -> things.add(base.home(), device, facts));
    return speaker.map(device -> with(base, things.present(device))).orElse(base);
  }

  /** What is said beside that there are things. */
  List<Fact> others(World base, Source source, List<Fact> facts) {
    Optional<Device> speaker = speaker(base, source);
    return facts.stream()
        .filter(
            fact ->
                speaker.filter(device -> things.isOfAThing(base.home(), device, fact)).isEmpty())
        .toList();
  }

  /** Without things that their device does not tell any more, and of which nothing is known. */
  World withoutWhatIsGone(World base, Source source, List<Fact> facts) {
    return speaker(base, source)
        .map(
            device -> {
              things.keepOnly(base, device, facts);
              return with(base, things.present(device));
            })
        .orElse(base);
  }

  /** What the device told of a thing after its step may have come to be known before. */
  World recalling(World base, FeatureRun run) {
    return Optional.ofNullable(base.home().devices().get(run.member()))
        .filter(device -> things.recall(base, run.member(), run.bindings().values()))
        .map(device -> with(base, things.present(device)))
        .orElse(base);
  }

  private static Optional<Device> speaker(World base, Source source) {
    return Optional.ofNullable(base.home().devices().get(source.agent()))
        .filter(device -> source.kind() == Source.Kind.STATED);
  }

  private World with(World base, Device device) {
    Home home = base.home();
    if (device.equals(home.devices().get(device.id()))) {
      return base;
    }
    home.contradiction(device)
        .ifPresent(
            contradiction -> {
              throw new KnowledgeException(contradiction.sentence(device.id()));
            });
    Home changed = home.with(device);
    Measures measured = measured(changed, device);
    Graphs graphs = new Graphs(changed);
    if (!changed.vocabulary().equals(home.vocabulary())) {
      storage.replace(graphs.vocabularyGraph(), graphs.vocabulary());
    }
    store(graphs, device);
    return base.with(changed, measured, base.version() + 1);
  }

  /** The world of a home in which another agent of a group is there, or one less. */
  World changed(World base, Home home) {
    return base.with(home, measures.apply(home), base.version() + 1);
  }

  /** Keeps what the home's file says of all but devices. */
  void store(Graphs graphs, Home home) {
    storage.replace(
        graphs.homeGraph(),
        home.individuals().values().stream()
            .filter(individual -> !home.devices().containsKey(individual.name()))
            .flatMap(individual -> graphs.individual(individual).stream())
            .toList());
  }

  /** Keeps what is said of the agent of a group. */
  void store(Graphs graphs, Group group) {
    storage.replace(graphs.memberGraph(group.id()), graphs.individual(group.individual()));
  }

  /** Keeps nothing any more of what was said of an agent. */
  void remove(Graphs graphs, String agent) {
    storage.replace(graphs.memberGraph(agent), List.of());
  }

  /** What cannot be measured is refused before anything of it is kept. */
  private Measures measured(Home changed, Device device) {
    try {
      return measures.apply(changed);
    } catch (IllegalArgumentException e) {
      throw new KnowledgeException(
          "%s brings coordinates that cannot be read: %s"
              .formatted(device.id(), Objects.requireNonNullElse(e.getMessage(), e.toString())),
          e);
    }
  }

  /** Keeps what is said of the device and of its things. */
  void store(Graphs graphs, Device device) {
    storage.replace(
        graphs.memberGraph(device.id()),
        Stream.concat(Stream.of(device.individual()), device.extension().things().values().stream())
            .flatMap(individual -> graphs.individual(individual).stream())
            .toList());
  }
}

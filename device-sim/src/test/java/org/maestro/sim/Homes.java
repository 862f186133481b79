package org.maestro.sim;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.world.World;

/** The shipped homes and scenes, simulated on a stepped clock behind a link. */
public final class Homes implements AutoCloseable {

  private static final Path RESOURCES = Path.of("../scenarios/assembly/src/main/resources");

  public final SteppedClock clock = new SteppedClock();
  public final InProcessBus bus = new InProcessBus(clock);
  public final Home home;
  public final Scene scene;
  public final SimulatedHome simulated;
  public final RatsLink link;

  public Homes(String homeName, String sceneName, long seed, UnaryOperator<Scene> changed) {
    this(home(homeName), home -> changed.apply(scene(sceneName, home)), seed);
  }

  public Homes(Home home, Scene scene, long seed) {
    this(home, same -> scene, seed);
  }

  private Homes(Home home, Function<Home, Scene> scene, long seed) {
    this(home, scene.apply(home), seed, usual -> usual);
  }

  /** With other physics. */
  public Homes(Home home, Scene scene, long seed, UnaryOperator<PhysicalParameters> physics) {
    this.home = home;
    this.scene = scene;
    simulated =
        SimulatedHome.start(
            new SimulatedHome.Setup(
                    home,
                    scene,
                    clock,
                    seed,
                    bus::client,
                    "test",
                    new DescriptionWriter(home)::write)
                .with(physics.apply(PhysicalParameters.standard()))
                .on(bus));
    link = BusLink.connect("cca", "test", bus.client("cca"), clock);
    clock.run(Duration.ofMillis(100));
  }

  public static Homes bob(String scene) {
    return new Homes("bob", scene, 1, same -> same);
  }

  public static Home home(String name) {
    return new HomeLoader().load(RESOURCES.resolve("homes/" + name + ".ttl"));
  }

  /** The text of a shipped home. */
  public static String text(String name) {
    try {
      return Files.readString(RESOURCES.resolve("homes/" + name + ".ttl"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public static Scene scene(String name, Home home) {
    try (InputStream turtle = Files.newInputStream(RESOURCES.resolve("scenes/" + name + ".ttl"))) {
      return SceneLoader.load(name, turtle, home);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public World world() {
    return simulated.world();
  }

  public static Map<String, Object> ref(String name) {
    return Map.of("ref", "https://w3id.org/maestro/home/bob#" + name);
  }

  public Map<String, Object> at(String name) {
    var place = world().position(name).orElseThrow();
    return Map.of(
        "ref",
        "https://w3id.org/maestro/home/bob#" + name,
        "position",
        List.of(place.x(), place.y(), place.z()));
  }

  /** Calls and runs until the result, or until a continuous feature is established. */
  public Answer call(String member, String feature, Map<String, Object> parameters) {
    AtomicReference<Optional<Answer>> answer = new AtomicReference<>(Optional.empty());
    AtomicReference<Optional<RatsLink.CallHandle>> handle = new AtomicReference<>(Optional.empty());
    handle.set(
        Optional.of(
            link.call(
                member,
                feature,
                parameters,
                Duration.ofSeconds(60),
                Optional.empty(),
                new RatsLink.CallListener() {
                  @Override
                  public void progressed(Progress progress) {
                    if (progress.kind() == Progress.Kind.ESTABLISHED) {
                      answer.set(
                          Optional.of(
                              new Answer(handle.get(), Optional.empty(), progress.values())));
                    }
                  }

                  @Override
                  public void observed(Observation observation) {}

                  @Override
                  public void ended(Result result) {
                    answer.set(
                        Optional.of(
                            new Answer(handle.get(), Optional.of(result), result.values())));
                  }
                })));
    clock.runUntil(() -> answer.get().isPresent(), Duration.ofSeconds(90));
    return answer.get().orElseThrow();
  }

  public List<String> facts(String member) {
    return link.members().stream()
        .filter(known -> known.id().equals(member))
        .findFirst()
        .flatMap(RatsLink.Member::state)
        .orElseThrow()
        .values();
  }

  @Override
  public void close() {
    link.close();
    simulated.close();
    clock.run(Duration.ofMillis(100));
  }

  /**
   * @param result empty when established
   */
  public record Answer(
      Optional<RatsLink.CallHandle> handle, Optional<Result> result, Map<String, Object> values) {}
}

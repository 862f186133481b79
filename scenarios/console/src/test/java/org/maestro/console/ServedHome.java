package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.awaitility.Awaitility;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.api.Api;
import org.maestro.console.truth.TrueThing;
import org.maestro.console.truth.Truth;
import org.maestro.dialogue.Paraphraser;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.rats.security.SiteUsers;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.world.World;

/** Bob's home, simulated, with its console; and a client of that. */
final class ServedHome implements AutoCloseable {
  private static final double SPEED = 20;
  private static final String NAME = "served";
  private static final Duration FORMER_ENDS_WITHIN = Duration.ofSeconds(60);
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /** An answer of the console. */
  record Answer(int status, JsonNode document) {
    String problem() {
      return document.path("problem").asText();
    }
  }

  private final HttpClient client;
  private final LocalSite site;
  private final Console console;

  private ServedHome(LocalSite site, Console console, HttpClient client) {
    this.site = site;
    this.console = console;
    this.client = client;
  }

  static ServedHome start() {
    return start(NAME, settings -> {}, Optional.empty());
  }

  /** The same on a broker of one's own. */
  static ServedHome startOn(URI broker) {
    return start(NAME, settings -> settings.broker(broker), Optional.empty());
  }

  /**
   * The same for containers of other processes: what JADE has for a whole process goes with its
   * last platform, also while another begins, and platforms of one name get into each other's way.
   */
  static ServedHome startForOthers(URI broker) {
    Awaitility.await()
        .atMost(FORMER_ENDS_WITHIN)
        .until(
            () ->
                Thread.getAllStackTraces().keySet().stream()
                    .noneMatch(thread -> thread.getName().equals("maestro-container-end")));
    return start(
        NAME + "-" + Long.toString(System.nanoTime(), Character.MAX_RADIX),
        settings -> settings.broker(broker),
        Optional.empty());
  }

  /**
   * The same with more in its home.
   *
   * @param turtle what is added, such as scripts
   */
  static ServedHome startWithMore(String turtle) {
    Home home = new HomeLoader().load(resource("/homes/bob.ttl") + turtle, "bob-and-more.ttl");
    return start(
        NAME,
        home,
        settings -> {},
        Optional.empty(),
        Serving.onLoopback(0),
        HttpClient.newHttpClient(),
        ServedHome::truth);
  }

  /** The same, which asks somebody what was meant. */
  static ServedHome startAsking(Paraphraser paraphraser) {
    return start(
        NAME,
        new HomeLoader().load(resource("/homes/bob.ttl"), "bob.ttl"),
        settings -> {},
        Optional.empty(),
        new Serving(Serving.LOOPBACK, 0, Optional.empty(), paraphraser),
        HttpClient.newHttpClient(),
        ServedHome::truth);
  }

  /** The same, of which nobody tells what is true. */
  static ServedHome startUntrue() {
    Home home = new HomeLoader().load(resource("/homes/bob.ttl"), "bob.ttl");
    return start(
        NAME,
        home,
        settings -> {},
        Optional.empty(),
        Serving.onLoopback(0),
        HttpClient.newHttpClient(),
        site -> Optional.empty());
  }

  /**
   * The flat whose rooms listen, in Bob's place.
   *
   * @param other what is otherwise in its text
   */
  static ServedHome startRooms(UnaryOperator<String> other) {
    Home home = new HomeLoader().load(other.apply(resource("/homes/rooms.ttl")), "rooms.ttl");
    return start(
        NAME,
        home,
        settings -> settings.scene(SceneLoader.load("rooms", stream("/scenes/rooms.ttl"), home)),
        Optional.empty(),
        Serving.onLoopback(0),
        HttpClient.newHttpClient(),
        site -> Optional.empty());
  }

  /** The same with a directory in which its past is kept. */
  static ServedHome startWith(Path data) {
    return start(NAME, settings -> {}, Optional.of(data));
  }

  /**
   * The same, secured.
   *
   * @param files where its files are made
   * @param permissions of the home, in Turtle
   */
  static ServedHome startSecured(Path files, Map<String, Role> persons, String permissions) {
    Home home = new HomeLoader().load(resource("/homes/bob.ttl") + permissions, "bob-secured.ttl");
    SecureSite.in(files)
        .make(
            new SiteUsers(
                NAME,
                List.of("127.0.0.1"),
                new TreeSet<>(Set.of("maestro")),
                new TreeSet<>(home.devices().keySet()),
                new TreeSet<>(Set.of(LocalSite.OBSERVER)),
                new TreeSet<>(),
                new TreeMap<>(persons)));
    SiteSecurity security = SiteSecurity.open(files);
    HttpClient client =
        HttpClient.newBuilder()
            .sslContext(security.console(persons.keySet().iterator().next()).orElseThrow().tls())
            .build();
    return start(
        NAME,
        home,
        settings -> settings.security(security),
        Optional.empty(),
        new Serving(Serving.LOOPBACK, 0, Optional.of(security)),
        client,
        ServedHome::truth);
  }

  private static ServedHome start(
      String name, Consumer<SiteSettings.Builder> more, Optional<Path> data) {
    return start(
        name,
        new HomeLoader().load(resource("/homes/bob.ttl"), "bob.ttl"),
        more,
        data,
        Serving.onLoopback(0),
        HttpClient.newHttpClient(),
        ServedHome::truth);
  }

  private static ServedHome start(
      String name,
      Home home,
      Consumer<SiteSettings.Builder> more,
      Optional<Path> data,
      Serving serving,
      HttpClient client,
      Function<LocalSite, Optional<Truth>> truth) {
    SiteSettings.Builder settings = SiteSettings.of(name, home);
    if (home.individuals().containsKey("Bob")) {
      settings.scene(SceneLoader.load("bob-dark", stream("/scenes/bob-dark.ttl"), home));
    }
    more.accept(settings);
    LocalSite site = LocalSite.paced(settings.build(), SPEED);
    Console console =
        Console.start(
            site.platform(), site.observer(), name, serving, data, truth.apply(site), "1.2.3");
    site.simulated().facesAreShownBy(console::isFaceShown);
    return new ServedHome(site, console, client);
  }

  /** Where Bob and what he asks for truly are, and what the lamps and the door are at. */
  private static Optional<Truth> truth(LocalSite site) {
    World world = site.world();
    return Optional.of(
        () ->
            List.of(
                at(world, "Bob"),
                at(world, "Cup"),
                at(world, "rose"),
                new TrueThing(
                    "lamp-a1",
                    Optional.empty(),
                    Optional.empty(),
                    OptionalDouble.of(world.lampLevel("lamp-a1")),
                    Optional.empty()),
                new TrueThing(
                    "door-ab",
                    Optional.empty(),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    Optional.of(world.isOpen("door-ab")))));
  }

  private static TrueThing at(World world, String name) {
    return new TrueThing(
        name,
        world.position(name).map(place -> new TrueThing.Spot(place.x(), place.y())),
        world.holder(name),
        OptionalDouble.empty(),
        Optional.empty());
  }

  private static InputStream stream(String name) {
    return Objects.requireNonNull(LocalSite.class.getResourceAsStream(name), name);
  }

  private static String resource(String name) {
    try (InputStream text = stream(name)) {
      return new String(text.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  LocalSite site() {
    return site;
  }

  URI uri() {
    return console.uri();
  }

  /** What is answered outside of the API, whatever it is. */
  HttpResponse<String> whole(String path) throws IOException, InterruptedException {
    return client.send(
        HttpRequest.newBuilder(uri().resolve(path)).build(), HttpResponse.BodyHandlers.ofString());
  }

  Answer get(String path) throws IOException, InterruptedException {
    return send(to(path));
  }

  Answer post(String path, String body) throws IOException, InterruptedException {
    return send(
        to(path)
            .header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString(body)));
  }

  Answer delete(String path) throws IOException, InterruptedException {
    return send(to(path).DELETE());
  }

  HttpRequest.Builder to(String path) {
    return HttpRequest.newBuilder(uri().resolve(Api.ROOT + path));
  }

  Answer send(HttpRequest.Builder request) throws IOException, InterruptedException {
    HttpResponse<String> response =
        client.send(request.build(), HttpResponse.BodyHandlers.ofString());
    return new Answer(response.statusCode(), MAPPER.readTree(response.body()));
  }

  /** With its headers. */
  HttpResponse<String> sendWhole(HttpRequest.Builder request)
      throws IOException, InterruptedException {
    return client.send(request.build(), HttpResponse.BodyHandlers.ofString());
  }

  HttpResponse<InputStream> stream(HttpRequest request) throws IOException, InterruptedException {
    return client.send(request, HttpResponse.BodyHandlers.ofInputStream());
  }

  /** States a goal, and returns its id. */
  String state(String goal) throws IOException, InterruptedException {
    return post("/goals", MAPPER.createObjectNode().put("goal", goal).toString())
        .document()
        .path("id")
        .asText();
  }

  /** Makes sure that an answer is as the OpenAPI document says. */
  void assertValid(JsonNode answer, String name) throws IOException, InterruptedException {
    ObjectNode schema = MAPPER.createObjectNode();
    schema
        .put("$ref", "#/components/schemas/" + name)
        .set("components", get("/openapi.json").document().path("components"));
    assertThat(
            JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
                .getSchema(schema)
                .validate(answer))
        .as("%s: %s", name, answer)
        .isEmpty();
  }

  @Override
  public void close() {
    console.close();
    site.close();
  }
}

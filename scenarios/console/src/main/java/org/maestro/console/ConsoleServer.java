package org.maestro.console;

import io.javalin.Javalin;
import io.javalin.config.JavalinConfig;
import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.HandlerType;
import io.javalin.http.Header;
import io.javalin.http.HttpResponseException;
import io.javalin.http.staticfiles.Location;
import io.javalin.util.JavalinException;
import java.net.URI;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Semaphore;
import java.util.stream.Collectors;
import javax.net.ssl.SSLContext;
import org.eclipse.jetty.server.HttpConfiguration;
import org.eclipse.jetty.server.HttpConnectionFactory;
import org.eclipse.jetty.server.SecureRequestCustomizer;
import org.eclipse.jetty.server.ServerConnector;
import org.eclipse.jetty.util.ssl.SslContextFactory;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.maestro.console.access.DeniedException;
import org.maestro.console.access.Visit;
import org.maestro.console.api.Api;
import org.maestro.console.api.Operation;
import org.maestro.console.questions.RefusalException;
import org.maestro.rats.security.Role;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The server of a console: it looks at each request, lets it in, reads it, has an operation answer
 * it, and says why where none does.
 */
final class ConsoleServer implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ConsoleServer.class);
  private static final int MOST_STRANGERS = 4;
  private static final int MOST_THREADS = 24;
  private static final int FEWEST_THREADS = 4;
  private static final Optional<Role> VIEWER = Optional.of(Role.VIEWER);

  /** Under which a stream finds who listens. */
  private static final String VISIT = "visit";

  /** The parameter by which who listens names what is shown. */
  private static final String CHOSEN = "of";

  /** Of the version in the POM; where there is no such directory, no server starts. */
  private static final String CHARTS = "/META-INF/resources/webjars/uplot/1.6.30";

  private final Serving serving;
  private final Entrance entrance;
  private final Gatekeeper gatekeeper;
  private final List<Operation> operations;
  private final Metrics metrics;
  private final EventStreams streams = new EventStreams();
  private final Semaphore strangers = new Semaphore(MOST_STRANGERS);
  private final Javalin server;

  private ConsoleServer(
      Serving serving,
      Entrance entrance,
      List<Operation> operations,
      String document,
      Health health,
      Metrics metrics,
      Map<String, EventSource> events) {
    this.serving = serving;
    this.entrance = entrance;
    this.gatekeeper = new Gatekeeper(serving);
    this.operations = List.copyOf(operations);
    this.metrics = metrics;
    this.server =
        Javalin.create(
            config -> {
              configure(config, document, health);
              events.forEach((path, source) -> stream(config.routes, path, source));
            });
  }

  /**
   * Starts it.
   *
   * @param document of the operations, as programs read it
   * @param events by their paths
   * @throws RefusalException when that does not work
   */
  static ConsoleServer start(
      Serving serving,
      Entrance entrance,
      List<Operation> operations,
      String document,
      Health health,
      Metrics metrics,
      Map<String, EventSource> events) {
    ConsoleServer made =
        new ConsoleServer(serving, entrance, operations, document, health, metrics, events);
    try {
      made.server.start(serving.host(), serving.port());
    } catch (JavalinException e) {
      throw RefusalException.outside("The console cannot be started: " + e.getMessage() + ".");
    }
    return made;
  }

  private void configure(JavalinConfig config, String document, Health health) {
    config.startup.showJavalinBanner = false;
    config.startup.showOldJavalinVersionWarning = false;
    config.startup.startupWatcherEnabled = false;
    config.http.maxRequestSize = ReadRequest.MOST_BYTES;
    config.http.prefer405over404 = true;
    config.jetty.threadPool = threads();
    config.jetty.modifyHttpConfiguration(http -> http.setSendServerVersion(false));
    serving.security().ifPresent(files -> secure(config, files.server()));
    config.staticFiles.add("/org/maestro/console/page", Location.CLASSPATH);
    config.staticFiles.add(
        files -> {
          files.hostedPath = "/uplot";
          files.directory = CHARTS;
          files.location = Location.CLASSPATH;
        });
    config.routes.before(this::look);
    for (Operation operation : operations) {
      config.routes.addHttpHandler(
          HandlerType.findOrCreate(operation.method().name()),
          Api.ROOT + operation.path(),
          context -> context.future(() -> answer(context, operation)));
    }
    config.routes.get(
        Api.ROOT + "/openapi.json",
        context -> context.contentType("application/json").result(document));
    config.routes.get("/health", context -> health.tellHealth(context, entrance.isKnown(context)));
    config.routes.get(
        "/ready",
        context -> context.future(() -> health.tellReadiness(context, entrance.isKnown(context))));
    config.routes.get(
        "/metrics",
        context -> {
          entrance.admit(context, VIEWER);
          context.future(() -> metrics.tell(context));
        });
    config.routes.exception(
        RefusalException.class, (refusal, context) -> Problems.answer(context, refusal));
    config.routes.exception(
        DeniedException.class, (denial, context) -> Problems.answer(context, denial));
    config.routes.exception(
        HttpResponseException.class,
        (failure, context) -> {
          if (failure.getStatus() == Problems.NOT_ALLOWED) {
            context.header("Allow", allowed(context.path()));
          }
          Problems.answer(context, failure.getStatus(), sentence(failure, context));
        });
    config.routes.exception(
        Exception.class, (failure, context) -> Problems.answer(context, failure));
    config.routes.error(
        Problems.NOT_FOUND,
        context -> {
          // What says by itself what is not there has been answered.
          if (Optional.ofNullable(context.result()).filter(text -> !text.isEmpty()).isEmpty()) {
            Problems.answer(context, Problems.NOT_FOUND, nothing(context));
          }
        });
  }

  private void stream(RoutesConfig routes, String path, EventSource source) {
    String at = Api.ROOT + path;
    routes.before(
        at,
        context -> {
          context.attribute(VISIT, entrance.admit(context, Optional.of(source.needs())));
          String accepted = Objects.requireNonNullElse(context.header(Header.ACCEPT), "");
          if (!accepted.contains(Operation.EVENTS)) {
            // To whom does not name it, Javalin answers with nothing.
            throw new HttpResponseException(Problems.NOT_ACCEPTABLE);
          }
        });
    routes.sse(
        at,
        client -> {
          Visit visit = Objects.requireNonNull(client.ctx().attribute(VISIT));
          String chosen = Objects.requireNonNullElse(client.ctx().queryParam(CHOSEN), "");
          streams.serve(client, source.of(chosen), visit);
        });
  }

  private void secure(JavalinConfig config, SSLContext own) {
    config.jetty.addConnector(
        (server, http) -> {
          SslContextFactory.Server tls = new SslContextFactory.Server();
          tls.setSslContext(own);
          HttpConfiguration secured = new HttpConfiguration(http);
          // A browser that asks for an address names no host to choose a certificate by.
          secured.addCustomizer(new SecureRequestCustomizer(false));
          ServerConnector connector =
              new ServerConnector(server, tls, new HttpConnectionFactory(secured));
          connector.setHost(serving.host());
          connector.setPort(serving.port());
          return connector;
        });
  }

  private static QueuedThreadPool threads() {
    QueuedThreadPool threads = new QueuedThreadPool(MOST_THREADS, FEWEST_THREADS);
    threads.setName("console");
    threads.setDaemon(true);
    return threads;
  }

  private void look(Context context) {
    Gatekeeper.mark(context);
    Optional<String> objection = gatekeeper.objection(context);
    if (objection.isPresent()) {
      Problems.answer(context, Problems.FORBIDDEN, objection.get());
      context.skipRemainingHandlers();
    }
  }

  private CompletableFuture<?> answer(Context context, Operation operation) {
    long begin = System.nanoTime();
    CompletableFuture<?> answer;
    try {
      Visit visit = entrance.admit(context, operation);
      answer = operation.answer(read(context, operation, visit));
      visit.person().ifPresent(person -> note(person, context, operation));
    } catch (RefusalException | DeniedException e) {
      answer = CompletableFuture.failedFuture(e);
    }
    return answer.handle(
        (document, failure) -> {
          if (failure != null) {
            Problems.answer(context, failure);
          } else if (operation.answer().isEmpty()) {
            context.status(operation.status());
          } else {
            context
                .status(operation.status())
                .contentType(operation.media())
                .result(Objects.requireNonNull(document).toString());
          }
          metrics.answered(
              operation.id(), context.statusCode(), Duration.ofNanos(System.nanoTime() - begin));
          return null;
        });
  }

  /**
   * Reads a request. Whoever is not known may hold a few threads at most by sending slowly.
   *
   * @throws RefusalException when it is otherwise than the operation says
   */
  private ReadRequest read(Context context, Operation operation, Visit visit) {
    boolean isStranger = operation.body().isPresent() && visit.role().isEmpty();
    if (isStranger && !strangers.tryAcquire()) {
      throw RefusalException.outside("Too many sign in just now; try again in a moment.");
    }
    try {
      return ReadRequest.of(context, operation, visit);
    } finally {
      if (isStranger) {
        strangers.release();
      }
    }
  }

  /** Who has changed what, for who keeps the site. */
  private static void note(String person, Context context, Operation operation) {
    if (operation.needs().filter(role -> role != Role.VIEWER).isPresent()) {
      LOG.info(
          "{} asks for {} at {} from {}", person, operation.id(), context.path(), context.ip());
    }
  }

  /** What can be done at a path. */
  private String allowed(String path) {
    String methods =
        operations.stream()
            .filter(operation -> operation.isAt(path))
            .map(operation -> operation.method().name())
            .distinct()
            .collect(Collectors.joining(", "));
    return methods.isEmpty() ? "GET" : methods;
  }

  private static String sentence(HttpResponseException failure, Context context) {
    return switch (failure.getStatus()) {
      case Problems.NOT_FOUND -> nothing(context);
      case Problems.NOT_ALLOWED ->
          "%s is not done with %s; %s/openapi.json tells what is."
              .formatted(context.method(), context.path(), Api.ROOT);
      case Problems.NOT_ACCEPTABLE ->
          "%s tells events as they come, and nothing else; ask with the header Accept: %s."
              .formatted(context.path(), Operation.EVENTS);
      default -> "It is not answered: " + failure.getMessage() + ".";
    };
  }

  private static String nothing(Context context) {
    return "There is nothing at %s; %s/openapi.json tells what there is."
        .formatted(context.path(), Api.ROOT);
  }

  /** At which it is reached from this machine. */
  URI uri() {
    String host = serving.isEverywhere() ? Serving.LOOPBACK : Serving.inAddress(serving.host());
    return URI.create(serving.scheme() + "://" + host + ":" + server.port());
  }

  @Override
  public void close() {
    streams.close();
    server.stop();
  }
}

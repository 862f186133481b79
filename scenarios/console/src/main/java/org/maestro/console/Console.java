package org.maestro.console;

import com.fasterxml.jackson.databind.node.ObjectNode;
import io.javalin.Javalin;
import io.javalin.config.JavalinConfig;
import io.javalin.config.RoutesConfig;
import io.javalin.http.Context;
import io.javalin.http.HandlerType;
import io.javalin.http.HttpResponseException;
import io.javalin.http.staticfiles.Location;
import io.javalin.util.JavalinException;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Collectors;
import org.eclipse.jetty.util.thread.QueuedThreadPool;
import org.maestro.console.api.Api;
import org.maestro.console.api.HistoryOperations;
import org.maestro.console.api.OpenApiDocument;
import org.maestro.console.api.Operation;
import org.maestro.console.api.PlanOperations;
import org.maestro.console.history.Answerer;
import org.maestro.console.history.History;
import org.maestro.console.members.MemberOperations;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.RefusalException;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.transport.Transport;

/**
 * The console of a platform of this process, on loopback (Three-layered architecture, 3; M25, M68):
 * a page for people, and the API that the page and all programs use. Any thread may close it.
 */
public final class Console implements AutoCloseable {
  private static final String HOST = "127.0.0.1";
  private static final long MOST_BYTES = 1_000_000;
  private static final int MOST_THREADS = 24;
  private static final int FEWEST_THREADS = 4;

  /** Of the version in the POM; where there is no such directory, no server starts. */
  private static final String CHARTS = "/META-INF/resources/webjars/uplot/1.6.30";

  private static final Duration MEASURED = Duration.ofSeconds(10);

  private final Javalin server;
  private final List<Runnable> ends;

  /**
   * @param ends of its parts, in the order in which they are to end
   */
  private Console(Javalin server, List<Runnable> ends) {
    this.server = server;
    this.ends = ends;
  }

  /**
   * Starts it.
   *
   * @param observer a client of the platform's bus that only listens; not open yet
   * @param name of the platform, and of its site on the bus
   * @param port on loopback; 0: a free one
   * @param data a directory in which the past is kept; empty: it ends with the process
   * @param version of the software
   * @throws RefusalException when the port is taken
   */
  public static Console start(
      MaestroPlatform platform,
      Transport observer,
      String name,
      int port,
      Optional<Path> data,
      String version) {
    requireFree(port);
    AclQuestions questions = new AclQuestions(platform.desk());
    Health health = new Health(questions, platform::containers, platform::impediments);
    History history =
        new History(
            data.map(directory -> directory.resolve("console")), platform::now, platform.speed());
    EventHub events =
        new EventHub(
            questions,
            platform.knowledge(),
            health::document,
            after -> history.answered(Answerer.AGENTS, after));
    Recording recording = new Recording(events, history, MEASURED);
    Traffic traffic =
        new Traffic(platform, name, observer, after -> history.answered(Answerer.MEMBERS, after));
    EventStreams streams = new EventStreams();
    Preview preview = new Preview(platform.knowledge(), platform::presentMembers);
    Queries queries = new Queries(platform.knowledge());
    OneByOne lookingBack =
        new OneByOne("console-past", "Others look back just now; ask again in a while.");
    List<Operation> operations =
        new ArrayList<>(
            new Api(
                    name,
                    platform.speed(),
                    questions,
                    platform.knowledge(),
                    preview::of,
                    queries::of)
                .operations());
    operations.addAll(PlanOperations.of(questions, platform::now));
    operations.addAll(traffic.operations());
    operations.addAll(new MemberOperations(platform, traffic.roundTrips()).operations());
    operations.addAll(new HistoryOperations(history, lookingBack::work).operations());
    ObjectNode document = OpenApiDocument.of(operations, version);
    Metrics metrics =
        new Metrics(
            questions, platform::containers, after -> history.answered(Answerer.API, after));
    Javalin server =
        Javalin.create(
            config -> {
              configure(config, operations, document.toString(), health, metrics);
              streams(config.routes, streams, events, traffic);
            });
    try {
      server.start(HOST, port);
    } catch (JavalinException e) {
      throw RefusalException.outside("The console cannot be started: " + e.getMessage() + ".");
    }
    platform.onStory(events::told);
    platform.onStory(metrics::told);
    events.start();
    traffic.begin();
    recording.begin();
    return new Console(
        server,
        List.of(
            streams::close,
            server::stop,
            preview::close,
            queries::close,
            lookingBack::close,
            recording::close,
            events::close,
            traffic::close,
            metrics::close));
  }

  private static void requireFree(int port) {
    try (ServerSocket tried = new ServerSocket()) {
      tried.setReuseAddress(true);
      tried.bind(new InetSocketAddress(InetAddress.getLoopbackAddress(), port));
    } catch (IOException e) {
      throw RefusalException.outside(
          "Port %d is in use, so the console cannot listen there; choose another one: --console PORT, or --console off."
              .formatted(port));
    }
  }

  private static void configure(
      JavalinConfig config,
      List<Operation> operations,
      String document,
      Health health,
      Metrics metrics) {
    config.startup.showJavalinBanner = false;
    config.startup.showOldJavalinVersionWarning = false;
    config.startup.startupWatcherEnabled = false;
    config.http.maxRequestSize = MOST_BYTES;
    config.http.prefer405over404 = true;
    config.jetty.threadPool = threads();
    config.jetty.modifyHttpConfiguration(http -> http.setSendServerVersion(false));
    config.staticFiles.add("/org/maestro/console/page", Location.CLASSPATH);
    config.staticFiles.add(
        files -> {
          files.hostedPath = "/uplot";
          files.directory = CHARTS;
          files.location = Location.CLASSPATH;
        });
    config.routes.before(Console::admit);
    for (Operation operation : operations) {
      config.routes.addHttpHandler(
          HandlerType.findOrCreate(operation.method().name()),
          Api.ROOT + operation.path(),
          context -> context.future(() -> answer(context, operation, metrics)));
    }
    config.routes.get(
        Api.ROOT + "/openapi.json",
        context -> context.contentType("application/json").result(document));
    config.routes.get("/health", health::tellHealth);
    config.routes.get("/ready", context -> context.future(() -> health.tellReadiness(context)));
    config.routes.get("/metrics", context -> context.future(() -> metrics.tell(context)));
    config.routes.exception(
        RefusalException.class, (refusal, context) -> Problems.answer(context, refusal));
    config.routes.exception(
        HttpResponseException.class,
        (failure, context) -> {
          if (failure.getStatus() == Problems.NOT_ALLOWED) {
            context.header("Allow", allowed(operations, context.path()));
          }
          Problems.answer(context, failure.getStatus(), sentence(failure, context));
        });
    config.routes.exception(
        Exception.class, (failure, context) -> Problems.answer(context, failure));
    config.routes.error(
        Problems.NOT_FOUND,
        context -> Problems.answer(context, Problems.NOT_FOUND, nothing(context)));
  }

  private static void streams(
      RoutesConfig routes, EventStreams streams, EventHub events, Traffic traffic) {
    routes.sse(Api.ROOT + "/events", client -> streams.serve(client, events));
    routes.sse(Api.ROOT + "/events/bus", client -> streams.serve(client, traffic.busNews()));
    routes.sse(
        Api.ROOT + "/events/conversations", client -> streams.serve(client, traffic.mailNews()));
  }

  private static QueuedThreadPool threads() {
    QueuedThreadPool threads = new QueuedThreadPool(MOST_THREADS, FEWEST_THREADS);
    threads.setName("console");
    threads.setDaemon(true);
    return threads;
  }

  private static void admit(Context context) {
    Gatekeeper.mark(context);
    Optional<String> objection = Gatekeeper.objection(context);
    if (objection.isPresent()) {
      Problems.answer(context, Problems.FORBIDDEN, objection.get());
      context.skipRemainingHandlers();
    }
  }

  private static CompletableFuture<?> answer(
      Context context, Operation operation, Metrics metrics) {
    long begin = System.nanoTime();
    CompletableFuture<?> answer;
    try {
      answer = operation.answer(ReadRequest.of(context, operation));
    } catch (RefusalException e) {
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
                .contentType("application/json")
                .result(Objects.requireNonNull(document).toString());
          }
          metrics.answered(
              operation.id(), context.statusCode(), Duration.ofNanos(System.nanoTime() - begin));
          return null;
        });
  }

  /** What can be done at a path. */
  private static String allowed(List<Operation> operations, String path) {
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
      default -> "It is not answered: " + failure.getMessage() + ".";
    };
  }

  private static String nothing(Context context) {
    return "There is nothing at %s; %s/openapi.json tells what there is."
        .formatted(context.path(), Api.ROOT);
  }

  /** Where the page is. */
  public URI uri() {
    return URI.create("http://" + HOST + ":" + server.port());
  }

  @Override
  public void close() {
    ends.forEach(Runnable::run);
  }
}

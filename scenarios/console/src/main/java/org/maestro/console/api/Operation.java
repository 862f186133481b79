package org.maestro.console.api;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.regex.Pattern;
import org.maestro.console.access.Visit;
import org.maestro.rats.security.Role;

/**
 * One operation of the API.
 *
 * @param path below {@link Api#ROOT}, with parameters in braces
 * @param id its name for programs, unique
 * @param summary what it does, a sentence
 * @param needs the role of who may ask for it on a secured site; empty: anybody may
 * @param urgent whether it is answered however much else its person asks
 * @param body the schema of what it takes; empty: nothing
 * @param status of a good answer
 * @param answer the schema of that answer; empty: it has no content
 * @param media the type of that content
 */
public record Operation(
    Method method,
    String path,
    String id,
    String summary,
    List<Parameter> parameters,
    Optional<Role> needs,
    boolean urgent,
    Optional<String> body,
    int status,
    Optional<String> answer,
    String media,
    Action action) {
  /** The type of what is no JSON but a text with a line for each record (RFC 4180). */
  public static final String CSV = "text/csv";

  /** The type of what goes on until either side ends it: server-sent events. */
  public static final String EVENTS = "text/event-stream";

  static final String JSON = "application/json";
  private static final int OK = 200;
  private static final int NO_CONTENT = 204;

  /** The methods of HTTP that operations use. */
  public enum Method {
    GET,
    POST,
    DELETE
  }

  /** What is asked for. */
  public interface Request {
    /** The value of a parameter that is always there. */
    String parameter(String name);

    /** The value of one that may be left away. */
    Optional<String> perhaps(String name);

    /** The same of a whole number. */
    default OptionalInt number(String name) {
      return perhaps(name)
          .map(Integer::parseInt)
          .map(OptionalInt::of)
          .orElseGet(OptionalInt::empty);
    }

    /** What was sent, an object as the schema says; an empty one where there is none. */
    JsonNode body();

    /** Who asks. */
    Visit visit();

    /** The address that it comes from. */
    String address();

    /** Has the browser bring this with each further request; empty: nothing any more. */
    void remember(Optional<String> session);
  }

  /** The work of an operation; it does not block. */
  @FunctionalInterface
  public interface Action {
    /** Completed with a document, or with nothing of use where there is no content. */
    CompletableFuture<?> answer(Request request);
  }

  /**
   * A parameter of the path, or of the query.
   *
   * @param type {@code string} or {@code integer}
   * @param required whether it is always there, as those of the path are
   */
  public record Parameter(
      String name, boolean inPath, String type, boolean required, String description) {

    public static Parameter path(String name, String description) {
      return new Parameter(name, true, "string", true, description);
    }

    public static Parameter query(String name, String description) {
      return new Parameter(name, false, "string", true, description);
    }

    /** One that may be left away. */
    public static Parameter perhaps(String name, String description) {
      return new Parameter(name, false, "string", false, description);
    }

    public static Parameter number(String name, String description) {
      return new Parameter(name, false, "integer", false, description);
    }
  }

  /** Whether a path of a request is one of its. */
  public boolean isAt(String requested) {
    return requested.matches(Pattern.quote(Api.ROOT) + path.replaceAll("\\{\\w+}", "[^/]+"));
  }

  /**
   * Does it.
   *
   * @param request has all parameters that the operation requires
   * @throws org.maestro.console.questions.RefusalException when what was sent is otherwise than its
   *     schema says
   */
  public CompletableFuture<?> answer(Request request) {
    body.ifPresent(schema -> BodyCheck.check(schema, request.body()));
    return action.answer(request);
  }

  public static Operation get(
      String path, String id, String summary, String answer, Action action) {
    return asking(Method.GET, path, id, summary, answer, action);
  }

  /** What has something to answer, and changes nothing. */
  public static Operation asking(
      Method method, String path, String id, String summary, String answer, Action action) {
    return new Operation(
        method,
        path,
        id,
        summary,
        List.of(),
        Optional.of(Role.VIEWER),
        false,
        Optional.empty(),
        OK,
        Optional.of(answer),
        JSON,
        action);
  }

  /** What has records to answer, for programs that calculate with them. */
  public static Operation csv(String path, String id, String summary, Action action) {
    return new Operation(
        Method.GET,
        path,
        id,
        summary,
        List.of(),
        Optional.of(Role.VIEWER),
        false,
        Optional.empty(),
        OK,
        Optional.of("csv"),
        CSV,
        action);
  }

  /** An order, which has no content to answer, and takes an operator. */
  public static Operation order(
      Method method, String path, String id, String summary, Action action) {
    return new Operation(
        method,
        path,
        id,
        summary,
        List.of(),
        Optional.of(Role.OPERATOR),
        false,
        Optional.empty(),
        NO_CONTENT,
        Optional.empty(),
        JSON,
        action);
  }

  public Operation with(Parameter... more) {
    return new Operation(
        method,
        path,
        id,
        summary,
        List.of(more),
        needs,
        urgent,
        body,
        status,
        answer,
        media,
        action);
  }

  /** The same for those of the role, and of any that includes it. */
  public Operation by(Role role) {
    return by(Optional.of(role));
  }

  /** The same however much else is asked. */
  public Operation atOnce() {
    return new Operation(
        method, path, id, summary, parameters, needs, true, body, status, answer, media, action);
  }

  /** The same for who has not signed in, too. */
  public Operation byAnybody() {
    return by(Optional.empty());
  }

  private Operation by(Optional<Role> role) {
    return new Operation(
        method, path, id, summary, parameters, role, urgent, body, status, answer, media, action);
  }

  public Operation taking(String schema) {
    return new Operation(
        method,
        path,
        id,
        summary,
        parameters,
        needs,
        urgent,
        Optional.of(schema),
        status,
        answer,
        media,
        action);
  }

  public Operation answering(int good, String schema) {
    return new Operation(
        method,
        path,
        id,
        summary,
        parameters,
        needs,
        urgent,
        body,
        good,
        Optional.of(schema),
        media,
        action);
  }
}

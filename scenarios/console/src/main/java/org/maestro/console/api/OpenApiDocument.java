package org.maestro.console.api;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.maestro.rats.security.Role;

/** The OpenAPI document of the operations that are answered. */
public final class OpenApiDocument {
  private static final String PROBLEM = "problem";

  /** What each operation may answer when it does not do what it is for. */
  private static final SortedMap<Integer, String> PROBLEMS =
      new TreeMap<>(
          Map.of(
              400, "It cannot be understood, or speaks of what is not there.",
              401, "The site is secured, and it is not known who asks.",
              403,
                  "It comes from a page of another site, or for another host, or who asks may not.",
              404, "Here is nothing of the kind.",
              413, "What was sent is too long.",
              429, "It was asked too often; Retry-After says when it is answered again.",
              503, "Something outside failed; the same may be answered later."));

  private OpenApiDocument() {}

  /**
   * @param version of the platform's software
   */
  public static ObjectNode of(List<Operation> operations, String version) {
    ObjectNode document = new ObjectMapper().createObjectNode();
    document.put("openapi", "3.1.0");
    document
        .putObject("info")
        .put("title", "MAESTRO")
        .put("version", version)
        .put("description", "States goals to a running platform, and tells what becomes of them.");
    document.putArray("servers").addObject().put("url", Api.ROOT);
    ObjectNode paths = document.putObject("paths");
    SortedMap<String, ObjectNode> schemas = new TreeMap<>();
    schemas.put(PROBLEM, Schemas.named(PROBLEM));
    for (Operation operation : operations) {
      add(paths, operation);
      operation.body().ifPresent(name -> schemas.put(name, Schemas.named(name)));
      operation.answer().ifPresent(name -> schemas.put(name, Schemas.named(name)));
    }
    events(
        paths,
        "/events",
        "events",
        "What happens, as server-sent events: first all that is so (home, facts, goals,"
            + " agents), then what changes, and each sentence of each story.");
    events(
        paths,
        "/events/bus",
        "busEvents",
        "The messages of the bus, as server-sent events of the name bus, each a document as that"
            + " of /bus: first all that are kept, then those that come.");
    events(
        paths,
        "/events/chat",
        "chatEvents",
        "What is said in conversations with persons, as server-sent events of the name chat, each a"
            + " document as that of /chat: first all that is kept, then what is said.");
    events(
        paths,
        "/events/conversations",
        "conversationEvents",
        "The conversations between agents, as server-sent events of the name conversations, each a"
            + " document as that of /conversations: first all, then those in which something is"
            + " said.");
    events(
        paths,
        "/events/faces",
        "faceEvents",
        "What the faces of the home show, as server-sent events of the name faces, each a document"
            + " as that of /faces: first all, then those that show something else. Who shows one"
            + " names it, as in /events/faces?of=screen-living.");
    events(
        paths,
        "/events/streams",
        "streamEvents",
        "The pictures and sound that a member streams now, as server-sent events of the name streams,"
            + " for an operator who names the member, as in /events/streams?of=cam-kitchen: each a"
            + " document with member, feature, call, number, type, captured_at, delay_ms and data in"
            + " base64. To listen has nothing streamed; what one cannot take in time is left out.",
        Role.OPERATOR);
    ObjectNode components = document.putObject("components");
    components.putObject("schemas").setAll(schemas);
    components
        .putObject("securitySchemes")
        .putObject("password")
        .put("type", "http")
        .put("scheme", "basic")
        .put(
            "description",
            "A person of a secured site; pages begin a session instead. An open site asks nobody.");
    document
        .putArray("security")
        .add(document.objectNode().set("password", document.arrayNode()))
        .addObject();
    return document;
  }

  private static void add(ObjectNode paths, Operation operation) {
    ObjectNode node =
        at(paths, operation.path())
            .putObject(operation.method().name().toLowerCase(Locale.ROOT))
            .put("operationId", operation.id())
            .put("summary", operation.summary());
    operation.needs().ifPresent(role -> node.put("x-role", role.word()));
    if (!operation.parameters().isEmpty()) {
      ArrayNode parameters = node.putArray("parameters");
      operation.parameters().forEach(parameter -> add(parameters.addObject(), parameter));
    }
    operation
        .body()
        .ifPresent(
            name ->
                refer(node.putObject("requestBody").put("required", true), Operation.JSON, name));
    ObjectNode responses = node.putObject("responses");
    ObjectNode good = responses.putObject(String.valueOf(operation.status()));
    good.put("description", "It is done.");
    operation.answer().ifPresent(name -> refer(good, operation.media(), name));
    problems(responses);
  }

  private static ObjectNode at(ObjectNode paths, String path) {
    return paths.has(path) ? (ObjectNode) paths.get(path) : paths.putObject(path);
  }

  private static void add(ObjectNode node, Operation.Parameter parameter) {
    node.put("name", parameter.name())
        .put("in", parameter.inPath() ? "path" : "query")
        .put("required", parameter.required())
        .put("description", parameter.description());
    ObjectNode schema = node.putObject("schema").put("type", parameter.type());
    if (parameter.type().equals("integer")) {
      schema.put("format", "int32").put("minimum", 0);
    }
  }

  private static void problems(ObjectNode responses) {
    PROBLEMS.forEach((status, description) -> problem(responses, status, description));
  }

  private static void problem(ObjectNode responses, int status, String description) {
    refer(
        responses.putObject(String.valueOf(status)).put("description", description),
        Operation.JSON,
        PROBLEM);
  }

  private static void refer(ObjectNode node, String media, String schema) {
    node.putObject("content")
        .putObject(media)
        .putObject("schema")
        .put("$ref", "#/components/schemas/" + schema);
  }

  /** They have no end, which operations of the table have. */
  private static void events(ObjectNode paths, String path, String id, String summary) {
    events(paths, path, id, summary, Role.VIEWER);
  }

  private static void events(ObjectNode paths, String path, String id, String summary, Role role) {
    ObjectNode get =
        at(paths, path)
            .putObject("get")
            .put("operationId", id)
            .put("summary", summary)
            .put("x-role", role.word());
    ObjectNode responses = get.putObject("responses");
    responses
        .putObject("200")
        .put("description", "Events until either side ends it.")
        .putObject("content")
        .putObject(Operation.EVENTS)
        .putObject("schema")
        .put("type", "string");
    problem(responses, 406, "It was asked without the header Accept: " + Operation.EVENTS + ".");
  }
}

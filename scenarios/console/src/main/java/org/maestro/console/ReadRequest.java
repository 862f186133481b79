package org.maestro.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import io.javalin.http.ContentTooLargeResponse;
import io.javalin.http.Context;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.console.access.Visit;
import org.maestro.console.api.Operation;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.questions.RefusalException;

/**
 * A request whose parameters and body are as its operation says.
 *
 * @param values of the parameters that are there
 * @param remembering has the browser bring something with each further request
 */
record ReadRequest(
    Map<String, String> values,
    JsonNode body,
    Visit visit,
    String address,
    Consumer<Optional<String>> remembering)
    implements Operation.Request {
  private static final ObjectMapper MAPPER =
      new ObjectMapper()
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .enable(DeserializationFeature.FAIL_ON_READING_DUP_TREE_KEY);
  static final int MOST_BYTES = 1_000_000;
  private static final int PART_BYTES = 8_192;
  private static final Duration WITHIN = Duration.ofSeconds(10);
  private static final String JSON = "application/json";

  /**
   * Reads it.
   *
   * @throws RefusalException when it is otherwise than the operation says
   */
  static ReadRequest of(Context context, Operation operation, Visit visit) {
    Map<String, String> values = new HashMap<>(context.pathParamMap());
    Set<String> known =
        operation.parameters().stream()
            .filter(parameter -> !parameter.inPath())
            .map(Parameter::name)
            .collect(Collectors.toCollection(TreeSet::new));
    for (Map.Entry<String, List<String>> given : context.queryParamMap().entrySet()) {
      if (!known.contains(given.getKey())) {
        throw RefusalException.badInput(
            "There is no parameter %s here; %s."
                .formatted(
                    given.getKey(),
                    known.isEmpty() ? "leave it away" : "there is " + String.join(", ", known)));
      }
      values.put(given.getKey(), given.getValue().get(0));
    }
    operation.parameters().forEach(parameter -> check(parameter, values));
    return new ReadRequest(
        values,
        operation.body().isPresent() ? body(context) : JsonNodeFactory.instance.objectNode(),
        visit,
        context.ip(),
        session -> Entrance.remember(context, session));
  }

  private static void check(Parameter parameter, Map<String, String> values) {
    String value = values.get(parameter.name());
    if (value == null && parameter.required()) {
      throw RefusalException.badInput("The parameter " + parameter.name() + " is missing.");
    }
    if (value != null && parameter.type().equals("integer") && !value.matches("\\d{1,9}")) {
      throw RefusalException.badInput(
          "%s is a whole number, not \"%s\".".formatted(parameter.name(), value));
    }
  }

  private static JsonNode body(Context context) {
    // Pages of other sites cannot send this type without being asked first, and then they may not.
    String type = Optional.ofNullable(context.contentType()).orElse("");
    if (!type.split(";", 2)[0].strip().equalsIgnoreCase(JSON)) {
      throw RefusalException.badInput("What is sent has to be JSON: Content-Type " + JSON + ".");
    }
    try {
      return MAPPER.readTree(sent(context));
    } catch (JsonProcessingException e) {
      throw RefusalException.badInput(
          "What was sent is no JSON document: " + e.getOriginalMessage() + ".");
    } catch (IOException e) {
      throw RefusalException.badInput("What was sent cannot be read.");
    }
  }

  /** All that is sent; who sends it drop by drop keeps no thread for long. */
  private static byte[] sent(Context context) throws IOException {
    long end = System.nanoTime() + WITHIN.toNanos();
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    byte[] part = new byte[PART_BYTES];
    InputStream in = context.bodyInputStream();
    for (int read = in.read(part); read >= 0; read = in.read(part)) {
      all.write(part, 0, read);
      if (all.size() > MOST_BYTES) {
        throw new ContentTooLargeResponse();
      }
      if (System.nanoTime() > end) {
        throw RefusalException.badInput(
            "What is sent did not arrive within %d s.".formatted(WITHIN.toSeconds()));
      }
    }
    return all.toByteArray();
  }

  @Override
  public String parameter(String name) {
    return perhaps(name)
        .orElseThrow(() -> new IllegalArgumentException("There is no parameter " + name + "."));
  }

  @Override
  public void remember(Optional<String> session) {
    remembering.accept(session);
  }

  @Override
  public Optional<String> perhaps(String name) {
    return Optional.ofNullable(values.get(name));
  }
}

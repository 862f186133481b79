package org.maestro.rats.link;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.CostExchange;
import org.maestro.rats.protocol.Result;

/** A call of {@code $cost}, whose result becomes one answer for each set of parameters. */
record CostQuestion(CostExchange exchange, Consumer<List<CostAnswer>> answer)
    implements RatsLink.CallListener {
  static final Duration TIMEOUT = Duration.ofSeconds(5);

  CostQuestion(String feature, List<Map<String, Object>> sets, Consumer<List<CostAnswer>> answer) {
    this(new CostExchange(feature, sets), answer);
  }

  Map<String, Object> parameters() {
    return exchange.parameters();
  }

  @Override
  public void ended(Result result) {
    answer.accept(exchange.answers(result));
  }
}

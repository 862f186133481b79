package org.maestro.platform.guard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jade.core.AID;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.net.URI;
import java.util.ArrayList;
import java.util.Date;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import javax.swing.event.EventListenerList;
import org.junit.jupiter.api.Test;

/** What may be deserialised in a process with containers, secured or not. */
class SerialFilterTest {

  @Test
  void whatAgentsAreMadeWithPasses() throws Exception {
    for (Object good :
        List.of(
            "text",
            new Object[] {"an agent's", 1, 2.5, true, new Object[] {'c', new Date(0)}},
            new String[] {"robots", "cameras"},
            new byte[] {1, 2})) {
      assertThat(read(good)).isNotNull();
    }
  }

  @Test
  void whatNobodySendsDoesNot() throws Exception {
    for (Object bad :
        List.of(
            new File("/"),
            URI.create("http://127.0.0.1/").toURL(),
            new EventListenerList(),
            new TreeMap<>(Map.of("a", 1)),
            Set.of("a"),
            new ArrayList<>(List.of("a")),
            new AID("rose@home", AID.ISGUID),
            new IllegalStateException("of whatever class"))) {
      assertThatThrownBy(() -> read(bad))
          .isInstanceOf(InvalidClassException.class)
          .hasMessageContaining("REJECTED");
      assertThatThrownBy(() -> read(new Object[] {bad})).isInstanceOf(InvalidClassException.class);
    }
  }

  @Test
  void whatIsTooLargeDoesNot() {
    for (Object large : List.of(nested(20), new Object[20_000], new byte[1 << 21])) {
      assertThatThrownBy(() -> read(large)).isInstanceOf(InvalidClassException.class);
    }
  }

  private static Object nested(int depth) {
    Object nested = "inmost";
    for (int n = 0; n < depth; n++) {
      nested = new Object[] {nested};
    }
    return nested;
  }

  private static Object read(Object written) throws IOException, ClassNotFoundException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(written);
    }
    try (ObjectInputStream in =
        new ObjectInputStream(new ByteArrayInputStream(bytes.toByteArray()))) {
      in.setObjectInputFilter(SerialFilter.ofCommands());
      return in.readObject();
    }
  }
}

package org.maestro.platform.guard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import jade.core.AID;
import jade.core.ContainerID;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;

/** What may be deserialised once a site is secured. */
class SerialFilterTest {

  @Test
  void whatAgentsNeedPasses() throws Exception {
    for (Object good :
        List.of(
            "text",
            new Object[] {"an agent's", 1, List.of(2.5)},
            new TreeMap<>(Map.of("a", new ArrayList<>(List.of(1L)))),
            new AID("rose", AID.ISLOCALNAME),
            new ContainerID("robots", null),
            new IllegalStateException("what went wrong"))) {
      assertThat(read(good)).isNotNull();
    }
  }

  @Test
  void whatNoAgentNeedsDoesNot() {
    for (Object bad : List.of(new File("/"), new javax.swing.event.EventListenerList())) {
      assertThatThrownBy(() -> read(bad))
          .isInstanceOf(InvalidClassException.class)
          .hasMessageContaining("REJECTED");
    }
    assertThatThrownBy(() -> read(new Object[] {List.of(new File("/"))}))
        .isInstanceOf(InvalidClassException.class);
    assertThatThrownBy(() -> read(nested(60))).isInstanceOf(InvalidClassException.class);
  }

  private static Object nested(int depth) {
    Object nested = "inmost";
    for (int n = 0; n < depth; n++) {
      nested = new ArrayList<>(List.of(nested));
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
      in.setObjectInputFilter(new SerialFilter());
      return in.readObject();
    }
  }
}
